// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

/// The views of a source, set after set.
struct ViewData {
  std::vector<datasets::ViewSet> sets;
  std::vector<std::string> labels;   ///< class of each view; of several sets "drill 2"
  std::vector<std::string> classes;  ///< each label once, in the order of its first view
  std::string fingerprint = {};      ///< SHA-256 over those of the sets

  /// All views, as they are numbered in `labels`.
  [[nodiscard]] std::size_t NumViews() const noexcept { return labels.size(); }
  [[nodiscard]] const datasets::ObjectView& View(std::size_t number) const;
};

/// Reads the folder of a source or makes its views, in folders below `made_folder`; goes on with
/// what an earlier call has made there. Throws Error as ReadViewSet and MakeViewSet do.
[[nodiscard]] ViewData ProvideViews(const ViewSource& source,
                                    const std::filesystem::path& made_folder,
                                    int num_threads,
                                    const Progress& progress);

/// The number of each view's label among `classes`. Throws Error(kBadInput) naming a label that is
/// none of them.
[[nodiscard]] std::vector<std::uint32_t> LabelNumbers(const std::vector<std::string>& labels,
                                                      std::span<const std::string> classes);

}  // namespace handcraft::experiments
