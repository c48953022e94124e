// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/metrics/binary_metrics.h"
#include "lib/core/design_matrix.h"

namespace handcraft::experiments {

/// Samples to fit and samples to measure on, of the same features; no group (object) is in both.
struct HeldOutData {
  std::size_t num_features = 0;
  std::vector<float> features = {};       ///< row-major, to fit
  std::vector<std::uint8_t> labels = {};  ///< 0 or 1
  std::vector<float> held_out_features = {};
  std::vector<std::uint8_t> held_out_labels = {};
  std::vector<std::size_t> held_out_groups = {};  ///< below num_held_out_groups
  std::size_t num_held_out_groups = 0;
};

struct HeldOutFitOptions {
  double ridge = 1.0;  ///< λ > 0: keeps every subset of the features solvable
  std::uint64_t seed = 1;
};

/// Weights of some columns, and how well they tell samples they have not seen.
struct HeldOutFit {
  std::vector<std::size_t> columns = {};  ///< ascending
  std::vector<double> weights = {};       ///< of them
  double intercept = 0.0;
  double log_loss = 0.0;  ///< mean on the held-out samples: half their deviance a sample
  double auc = 0.0;       ///< on them; NaN when a class is missing
  std::vector<double> group_losses = {};  ///< sums of the log-loss over each held-out group
  int iterations = 0;
};

/// Logistic regression on `columns`, begun at the weights that `start`, a fit of more columns, has
/// for them (nullptr: at the intercept alone). Runs on one thread, so that many may run at once.
/// Throws Error(kNoResult) when it does not converge, std::logic_error for columns that `start` or
/// the data do not have. Deterministic.
[[nodiscard]] HeldOutFit FitColumns(const HeldOutData& data,
                                    std::span<const std::size_t> columns,
                                    const HeldOutFit* start,
                                    const HeldOutFitOptions& options);

/// By how much the log-loss of `fit` is above that of `reference`, with the 95 % interval over the
/// held-out groups (both measured on the same ones).
[[nodiscard]] Estimate LossIncrease(const HeldOutFit& fit,
                                    const HeldOutFit& reference,
                                    const HeldOutData& data,
                                    std::uint64_t seed);

}  // namespace handcraft::experiments
