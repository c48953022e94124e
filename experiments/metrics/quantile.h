// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

namespace handcraft::experiments {

/// The value that has a share of the others below it: of n sorted values the one whose number is
/// share · (n − 1), rounded. `share` in [0, 1]: 0.5 is the median. NaN without values.
[[nodiscard]] double Quantile(std::vector<double> values, double share);

}  // namespace handcraft::experiments
