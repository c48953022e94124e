// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/lda/lda.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "lib/core/binary_labels.h"
#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/core/parallel.h"
#include "lib/linear_algebra/positive_definite.h"
#include "lib/linear_algebra/scatter.h"
#include "trainers/lda/ledoit_wolf.h"

namespace handcraft::lda {
namespace {

// Standard deviations within classes, divisor n; 0 where a column is constant within each.
std::vector<double> ScalesOf(const Scatter& scatter) {
  const std::size_t p = scatter.num_features;
  std::vector<double> scale(p);
  for (std::size_t j = 0; j < p; ++j) {
    scale[j] = std::sqrt(scatter.products[j * p + j] / static_cast<double>(scatter.NumRows()));
  }
  return scale;
}

// (1 − λ)R + λI, a constant column standing alone with a 1 on the diagonal.
std::vector<double> ShrunkCorrelation(const Scatter& scatter,
                                      std::span<const double> scale,
                                      double shrinkage) {
  const std::size_t p = scatter.num_features;
  const auto n = static_cast<double>(scatter.NumRows());
  std::vector<double> correlation(p * p, 0.0);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!(scale[i] > 0.0) || !(scale[j] > 0.0)) continue;
      correlation[i * p + j] =
          (1.0 - shrinkage) * scatter.products[i * p + j] / (n * scale[i] * scale[j]);
    }
    correlation[i * p + i] = 1.0;
  }
  return correlation;
}

void SetSingular(std::string message, Summary& summary) {
  summary.termination = Termination::kSingular;
  summary.message = std::move(message);
  summary.advice = "set shrinkage_rule to kLedoitWolf, or a shrinkage above 0";
}

// Fills weights and intercept, or says why there are none.
void Solve(const Scatter& scatter, std::span<const double> scale, Result& result) {
  Summary& summary = result.summary;
  const std::size_t p = scatter.num_features;
  std::vector<double> difference(p, 0.0);  // of the means, in scales
  for (std::size_t j = 0; j < p; ++j) {
    const double apart = scatter.Mean(1)[j] - scatter.Mean(0)[j];
    if (scale[j] > 0.0) {
      difference[j] = apart / scale[j];
    } else if (apart == 0.0) {
      summary.constant_features.push_back(j);
    } else {
      SetSingular(fmt::format("column {} (counted from 0) is constant within each class and tells "
                              "the classes apart alone",
                              j),
                  summary);
      summary.advice = "leave the column out: a threshold on it is the classifier";
      return;
    }
  }
  auto solution =
      SolvePositiveDefinite(ShrunkCorrelation(scatter, scale, summary.shrinkage), difference);
  if (!solution) {
    return SetSingular(fmt::format("the pooled covariance of {} features from {} samples is "
                                   "singular: some features are linear combinations of others",
                                   p,
                                   summary.num_samples),
                       summary);
  }
  summary.termination = Termination::kSolved;
  summary.message = fmt::format("solved with shrinkage {:.6g}", summary.shrinkage);
  summary.reciprocal_condition = solution->reciprocal_condition;
  const auto n = static_cast<double>(summary.num_samples);
  result.weights.assign(p, 0.0);
  result.intercept = std::log(summary.positive_prior / (1.0 - summary.positive_prior));
  for (std::size_t j = 0; j < p; ++j) {
    if (!(scale[j] > 0.0)) continue;
    result.weights[j] = solution->x[j] / scale[j] * ((n - 2.0) / n);
    result.intercept -= result.weights[j] * 0.5 * (scatter.Mean(0)[j] + scatter.Mean(1)[j]);
  }
}

// −2 Σ ln P(label), summed in fixed blocks.
template <class T>
double DevianceOf(const DesignMatrix<T>& X,
                  std::span<const std::uint8_t> labels,
                  const Result& result,
                  int num_threads) {
  constexpr std::size_t kRowsPerBlock = 1024;
  std::vector<double> sums((X.num_samples + kRowsPerBlock - 1) / kRowsPerBlock, 0.0);
  ParallelFor(sums.size(), num_threads, [&](std::size_t block) {
    const std::size_t end = std::min(X.num_samples, (block + 1) * kRowsPerBlock);
    for (std::size_t i = block * kRowsPerBlock; i < end; ++i) {
      double z = result.intercept;
      for (std::size_t j = 0; j < X.num_features; ++j) {
        z += result.weights[j] * static_cast<double>(X.Row(i)[j]);
      }
      const double against = labels[i] == 1 ? -z : z;  // ln(1 + e^against), without overflow
      sums[block] += std::max(0.0, against) + std::log1p(std::exp(-std::abs(against)));
    }
  });
  return 2.0 * std::accumulate(sums.begin(), sums.end(), 0.0);
}

double NullDeviance(double num_samples, double num_positive) {
  const double num_negative = num_samples - num_positive;
  return -2.0 * (num_positive * std::log(num_positive / num_samples) +
                 num_negative * std::log(num_negative / num_samples));
}

void FillNormaliser(const Scatter& scatter, std::span<const double> scale, Result& result) {
  const Summary& summary = result.summary;
  const double share =
      static_cast<double>(summary.num_positive) / static_cast<double>(summary.num_samples);
  result.feature_scale.assign(scale.begin(), scale.end());
  for (double& s : result.feature_scale) s = s > 0.0 ? s : 1.0;
  for (std::size_t j = 0; j < scatter.num_features; ++j) {
    result.feature_mean.push_back((1.0 - share) * scatter.Mean(0)[j] + share * scatter.Mean(1)[j]);
  }
}

}  // namespace

std::string_view NameOf(ShrinkageRule rule) noexcept {
  return rule == ShrinkageRule::kFixed ? "fixed" : "ledoit_wolf";
}

std::string_view NameOf(Termination termination) noexcept {
  switch (termination) {
    case Termination::kNotRun:
      return "not_run";
    case Termination::kSolved:
      return "solved";
    case Termination::kSingular:
      return "singular";
  }
  return "unknown";
}

void Options::Validate() const {
  const std::string name = "lda::Options.";
  RequireOption(shrinkage >= 0.0 && shrinkage <= 1.0, name + "shrinkage", shrinkage, "in [0, 1]");
  RequireOption(shrinkage_rule == ShrinkageRule::kFixed || shrinkage == 0.0,
                name + "shrinkage",
                shrinkage,
                "0 with the rule of Ledoit and Wolf, which finds its own");
  RequireOption(positive_prior >= 0.0 && positive_prior < 1.0,
                name + "positive_prior",
                positive_prior,
                "in (0, 1), or 0 for the samples' own");
  RequireOption(num_threads >= 1, name + "num_threads", num_threads, ">= 1");
}

template <class T>
Result TrainLda(const DesignMatrix<T>& X,
                std::span<const std::uint8_t> labels,
                const Options& options) {
  options.Validate();
  HC_CHECK(labels.size() == X.num_samples, labels.size(), X.num_samples);
  const std::size_t num_positive = CountPositive(labels);
  if (X.num_samples < 3) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "two samples, one a class, have no spread within their classes",
                 .remedy = "give more samples"});
  }
  const Scatter scatter = ComputeScatter(
      X, labels, 2, {.num_threads = options.num_threads, .progress = options.progress});
  const std::vector<double> scale = ScalesOf(scatter);
  Result result;
  Summary& summary = result.summary;
  summary.num_samples = X.num_samples;
  summary.num_positive = num_positive;
  const auto n = static_cast<double>(X.num_samples);
  const auto positive = static_cast<double>(num_positive);
  summary.positive_prior = options.positive_prior > 0.0 ? options.positive_prior : positive / n;
  summary.null_deviance = NullDeviance(n, positive);
  summary.shrinkage = options.shrinkage_rule == ShrinkageRule::kFixed
                          ? options.shrinkage
                          : LedoitWolfShare(X, labels, scatter, scale, options.num_threads);
  Solve(scatter, scale, result);
  FillNormaliser(scatter, scale, result);
  if (summary.termination == Termination::kSolved) {
    summary.deviance = DevianceOf(X, labels, result, options.num_threads);
  }
  return result;
}

template Result TrainLda(const DesignMatrix<float>&, std::span<const std::uint8_t>, const Options&);
template Result TrainLda(const DesignMatrix<double>&,
                         std::span<const std::uint8_t>,
                         const Options&);

}  // namespace handcraft::lda
