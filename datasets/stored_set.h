// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// The data set that a folder holds, of whatever kind: labelled pictures, or views of objects with
/// poses or holds beside them. Commands that take any kind open a set by it and ask it, so that no
/// command looks for files by itself.
struct StoredSet {
  std::variant<LabelledImageSet, ViewSet> pictures;
  bool has_demonstrations = false;  ///< demonstrations.csv stands beside views.csv
  bool has_holds = false;           ///< holds.csv stands beside views.csv

  [[nodiscard]] const std::filesystem::path& root() const;
  /// The file that lists the pictures.
  [[nodiscard]] std::filesystem::path list() const;
};

/// Reads manifest.csv or views.csv, whichever is there; poses and holds are not read. Throws Error
/// as ReadLabelledImageSet and ReadViewSet do, and when the folder holds neither list or both.
[[nodiscard]] StoredSet OpenSet(const std::filesystem::path& root);

/// What was looked at, and what was found.
struct CheckedSet {
  std::size_t num_images = 0;
  std::optional<std::size_t> num_demonstrations;  ///< none: there is no such file
  std::optional<std::size_t> num_holds;           ///< none: there is no such file
  std::vector<Fault> faults;                      ///< of pictures, then demonstrations, then holds
  std::vector<Fault> notes;                       ///< legal, and worth knowing
};

/// Opens every file of the set and names each fault, with the line where it stands in a list.
/// Same set, same faults for any number of threads.
[[nodiscard]] CheckedSet CheckSet(const StoredSet& set,
                                  int num_threads = 1,
                                  const Progress& progress = {});

/// Writes the splits that the pictures have now into the list, and nothing else. Throws Error when
/// it cannot be written or lists other pictures meanwhile.
void RewriteSplits(const StoredSet& set);

}  // namespace handcraft::datasets
