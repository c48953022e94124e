// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "experiments/metrics/confusion_rates.h"

namespace handcraft::experiments {

/// [[bad called bad, bad called good], [good called bad, good called good]], percent of all: the
/// layout of the dissertation, section 3.1.4.
using ConfusionPercent = std::array<std::array<double, 2>, 2>;

/// Of linear discriminant analysis on 330035 pixels (dissertation, section 3.1.4).
inline constexpr ConfusionPercent kDissertationLda = {{{54.20, 8.14}, {3.10, 34.56}}};

/// The same layout, each entry with its interval.
using ConfusionPercentEstimate = std::array<std::array<Estimate, 2>, 2>;

/// What it is if `bad_share` of the samples, in [0, 1], are bad, each class being told as often as
/// `rates` have it: matrices of different class ratios can be compared only so. The share is taken
/// as known; what varies are the rates. NaN for a class that is missing. Throws std::logic_error on
/// another share.
[[nodiscard]] ConfusionPercentEstimate PercentAtBadShare(const ConfusionRates& rates,
                                                         double bad_share);

/// Without the intervals.
[[nodiscard]] ConfusionPercent ValuesOf(const ConfusionPercentEstimate& percent) noexcept;

/// The share of bad samples in a table of percents, and in a matrix (0 of an empty one).
[[nodiscard]] double BadShareOf(const ConfusionPercent& percent) noexcept;
[[nodiscard]] double BadShareOf(const ConfusionMatrix& matrix) noexcept;

}  // namespace handcraft::experiments
