// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// What a group (image) gives to a figure that is one sum over groups divided by another: good best
/// pixels out of all that count, log-loss out of pixels.
struct GroupRatio {
  double sum = 0.0;
  double count = 0.0;

  GroupRatio& operator+=(const GroupRatio& other) noexcept {
    sum += other.sum;
    count += other.count;
    return *this;
  }
  [[nodiscard]] double Value() const noexcept { return sum / count; }  ///< NaN when both are 0
};

/// Σ sum / Σ count with its 95 % interval, bootstrap over *all* groups (BootstrapOverGroups): one
/// that counts nothing is drawn too, as it would be met again. No interval with fewer than two
/// groups that count. The one definition of the interval of such a figure, for a cell of a study as
/// for `evaluate`.
[[nodiscard]] Estimate EstimateRatio(std::span<const GroupRatio> groups,
                                     std::size_t num_resamples,
                                     std::uint64_t seed,
                                     int num_threads = 1);

/// The same for a share. One of exactly 0 or 1 leaves the bootstrap nothing to vary: its interval
/// is Wilson's, with as many trials as groups that count.
[[nodiscard]] Estimate EstimateShare(std::span<const GroupRatio> groups,
                                     std::size_t num_resamples,
                                     std::uint64_t seed,
                                     int num_threads = 1);

}  // namespace handcraft::experiments
