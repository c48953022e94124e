// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// The confusion matrix as an HTML table, each cell tinted by its share of its row.
[[nodiscard]] std::string ConfusionTable(const ConfusionMatrix& matrix, double threshold);

}  // namespace handcraft::experiments
