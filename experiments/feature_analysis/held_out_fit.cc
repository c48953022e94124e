// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/held_out_fit.h"

#include <algorithm>
#include <cmath>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::experiments {
namespace {

constexpr std::size_t kResamples = 1000;

// The columns of a row-major matrix, side by side.
std::vector<float> Pick(const std::vector<float>& matrix,
                        std::size_t num_columns,
                        std::span<const std::size_t> columns) {
  std::vector<float> picked;
  picked.reserve(matrix.size() / num_columns * columns.size());
  for (std::size_t row = 0; row < matrix.size(); row += num_columns) {
    for (const std::size_t column : columns) picked.push_back(matrix[row + column]);
  }
  return picked;
}

// Where the new fit begins: what goes is replaced by its mean, so that the intercept takes it over.
void SetStart(const HeldOutData& data,
              std::span<const std::size_t> columns,
              const HeldOutFit& start,
              logistic::Options& options) {
  options.initial_intercept = start.intercept;
  std::size_t next = 0;
  for (std::size_t k = 0; k < start.columns.size(); ++k) {
    const std::size_t column = start.columns[k];
    if (next < columns.size() && columns[next] == column) {
      options.initial_weights.push_back(start.weights[k]);
      ++next;
      continue;
    }
    double mean = 0.0;
    for (std::size_t row = column; row < data.features.size(); row += data.num_features) {
      mean += static_cast<double>(data.features[row]);
    }
    options.initial_intercept += start.weights[k] * mean / static_cast<double>(data.labels.size());
  }
  HC_CHECK(next == columns.size(), next, columns.size());
}

void Measure(const HeldOutData& data, HeldOutFit& fit) {
  const std::size_t n = data.held_out_labels.size();
  std::vector<double> scores(n, fit.intercept);
  fit.group_losses.assign(data.num_held_out_groups, 0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const float* row = data.held_out_features.data() + i * data.num_features;
    for (std::size_t k = 0; k < fit.columns.size(); ++k) {
      scores[i] += fit.weights[k] * static_cast<double>(row[fit.columns[k]]);
    }
    const double against = data.held_out_labels[i] == 1 ? -scores[i] : scores[i];
    const double loss = std::max(0.0, against) + std::log1p(std::exp(-std::abs(against)));
    sum += loss;
    fit.group_losses.at(data.held_out_groups[i]) += loss;
  }
  fit.log_loss = sum / static_cast<double>(n);
  fit.auc = RocAuc(scores, data.held_out_labels);
}

}  // namespace

HeldOutFit FitColumns(const HeldOutData& data,
                      std::span<const std::size_t> columns,
                      const HeldOutFit* start,
                      const HeldOutFitOptions& options) {
  HC_CHECK(!columns.empty() && columns.back() < data.num_features, columns.size());
  HC_CHECK(std::is_sorted(columns.begin(), columns.end()), columns.size());
  const std::vector<float> picked = Pick(data.features, data.num_features, columns);
  const DesignMatrix<float> X{.data = picked.data(),
                              .num_samples = data.labels.size(),
                              .num_features = columns.size(),
                              .stride = columns.size()};
  logistic::Options logistic{
      .ridge = options.ridge, .standard_errors = false, .num_threads = 1, .seed = options.seed};
  if (start != nullptr) {
    SetStart(data, columns, *start, logistic);
    logistic.warm_start_share = 0.0;  // near the optimum: exact Hessians at once
  }
  logistic::Result result = logistic::TrainLogistic(X, data.labels, logistic);
  if (result.summary.termination != logistic::Termination::kConverged) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "a fit of " + std::to_string(columns.size()) +
                           " features did not converge: " + result.summary.message,
                 .remedy = "raise the ridge"});
  }
  HeldOutFit fit{.columns = {columns.begin(), columns.end()},
                 .weights = std::move(result.weights),
                 .intercept = result.intercept,
                 .group_losses = {},
                 .iterations = result.summary.iterations};
  Measure(data, fit);
  return fit;
}

Estimate LossIncrease(const HeldOutFit& fit,
                      const HeldOutFit& reference,
                      const HeldOutData& data,
                      std::uint64_t seed) {
  std::vector<double> counts(data.num_held_out_groups, 0.0);
  for (const std::size_t group : data.held_out_groups) counts.at(group) += 1.0;
  const auto increase = [&](std::span<const std::size_t> groups) {
    double sum = 0.0;
    double count = 0.0;
    for (const std::size_t group : groups) {
      sum += fit.group_losses[group] - reference.group_losses[group];
      count += counts[group];
    }
    return sum / count;
  };
  return BootstrapOverGroups(data.num_held_out_groups, increase, kResamples, seed);
}

}  // namespace handcraft::experiments
