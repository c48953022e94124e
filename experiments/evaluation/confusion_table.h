// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "experiments/metrics/confusion_rates.h"

namespace handcraft::experiments {

/// The confusion matrix as an HTML table, each cell tinted by its share of its row, which stands in
/// it with its interval; `rates` are those of the matrix.
[[nodiscard]] std::string ConfusionTable(const ConfusionMatrix& matrix,
                                         const ConfusionRates& rates,
                                         double threshold);

}  // namespace handcraft::experiments
