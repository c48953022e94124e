// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace handcraft::experiments {

struct PrecisionRecallPoint {
  double recall = 0.0;     ///< share of the good samples that are called good
  double precision = 0.0;  ///< share of those called good that are good
};

/// Precision against recall as the threshold falls, one point a distinct score, thinned to at most
/// max_points ≥ 2 with both ends kept; the last has recall 1. Empty without good samples. Throws
/// std::logic_error on lengths that differ, NaN scores or labels other than 0/1. O(n log n).
[[nodiscard]] std::vector<PrecisionRecallPoint> PrecisionRecallCurve(
    std::span<const float> scores, std::span<const std::uint8_t> labels, std::size_t max_points);

}  // namespace handcraft::experiments
