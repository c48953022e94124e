// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "lib/runtime/model_header.h"

namespace handcraft::runtime {

/// Probability of label 1 for a row x of numbers: p = 1 / (1 + e^{−z}), z = intercept + Σ w · x.
struct LogisticModel {
  std::vector<double> weights;
  double intercept = 0.0;

  /// `row` is weights.size() long. Sums from front to back, so that every machine rounds alike.
  [[nodiscard]] double Probability(std::span<const double> row) const noexcept;
};

/// Builds a model of kind "logistic", version 1 (docs/model_format.md § 6), and runs the stored
/// self-test. Errors: HC_ERROR_CONTENT, HC_ERROR_SELF_TEST. Allocates (std::bad_alloc).
[[nodiscard]] Result<LogisticModel> LoadLogisticModel(const ParsedModel& model);

}  // namespace handcraft::runtime
