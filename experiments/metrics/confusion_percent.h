// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// [[bad called bad, bad called good], [good called bad, good called good]], percent of all: the
/// layout of the dissertation, section 3.1.4.
using ConfusionPercent = std::array<std::array<double, 2>, 2>;

/// Of linear discriminant analysis on 330035 pixels (dissertation, section 3.1.4).
inline constexpr ConfusionPercent kDissertationLda = {{{54.20, 8.14}, {3.10, 34.56}}};

/// NaN when the matrix is empty.
[[nodiscard]] ConfusionPercent PercentOf(const ConfusionMatrix& matrix) noexcept;

/// What it would be if `bad_share` of the samples, in [0, 1], were bad, each class being told as
/// often as it is: matrices of different class ratios can be compared only so. NaN for a class that
/// is missing. Throws std::logic_error on another share.
[[nodiscard]] ConfusionPercent PercentAtBadShare(const ConfusionMatrix& matrix, double bad_share);

/// The share of bad samples in a table of percents.
[[nodiscard]] double BadShareOf(const ConfusionPercent& percent) noexcept;

}  // namespace handcraft::experiments
