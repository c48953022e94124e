// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/importers/image_set_import.h"
#include "lib/core/error.h"

namespace handcraft::datasets {

/// What an import does without because a file is missing or holds nothing of use, kept until it is
/// told: no picture goes in silence.
class Omissions {
 public:
  /// The picture, or what belongs to one, at `path` is left out. `why` is the same text for all
  /// that lack the same thing, so that they become one note.
  void LeaveOut(const std::filesystem::path& path, const std::string& why);

  /// It is imported, but without `part` ("its cloud").
  void GoWithout(const std::filesystem::path& path,
                 const std::string& part,
                 const std::string& why);

  /// Those pictures go without, unless all `num_pictures` do: what no picture has was never there.
  void GoWithoutWhatOthersHave(const std::vector<std::filesystem::path>& lacking,
                               std::size_t num_pictures,
                               const std::string& part,
                               const std::string& why);

  /// A note for each reason, in the order of their first: with the path of its first and the number
  /// of all.
  [[nodiscard]] std::vector<Fault> Notes() const;

  /// Gives the notes to a source. Throws `refusal`, with the notes behind its reason, when no
  /// picture of it is left.
  void Conclude(SourceSet& source, Error::Details refusal) const;

 private:
  struct Group {
    std::string what, why;
    std::filesystem::path first;
    std::size_t count = 0;
  };

  void Add(const std::filesystem::path& path, const std::string& what, const std::string& why);

  std::vector<Group> groups_;
};

}  // namespace handcraft::datasets
