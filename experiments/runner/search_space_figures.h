// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "experiments/evaluation/grasp_point_evaluation.h"

namespace handcraft::experiments {

/// A stage of search-space reduction, mean over the pictures; one that was not reached counts 0.
struct SearchStageFigures {
  std::string stage = {};
  double num_pixels = 0.0;
  double time_ms = 0.0;
};

/// What search-space reduction came to on the pictures of a cell (dissertation, Table 3.1).
struct SearchSpaceFigures {
  std::size_t num_images_without_region = 0;
  std::vector<SearchStageFigures> stages = {};  ///< in their order; none without a region
};

/// Of the pictures whose grasp points were looked for in a region; stages are told by their names.
[[nodiscard]] SearchSpaceFigures SearchSpaceOf(std::span<const ImageScore> images);

/// Mean of the stages and sum of the pictures without a region over repetitions.
[[nodiscard]] SearchSpaceFigures Pooled(std::span<const SearchSpaceFigures> repetitions);

}  // namespace handcraft::experiments
