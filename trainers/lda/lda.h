// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/core/progress.h"

namespace handcraft::lda {

/// How much the pooled correlation is shrunk towards the identity.
enum class ShrinkageRule : std::uint8_t {
  kFixed,       ///< by Options.shrinkage
  kLedoitWolf,  ///< by the share that the data call for (ledoit_wolf.h)
};
[[nodiscard]] std::string_view NameOf(ShrinkageRule rule) noexcept;

struct Options {
  ShrinkageRule shrinkage_rule = ShrinkageRule::kFixed;
  double shrinkage = 0.0;  ///< λ in [0, 1] of (1 − λ)R + λI; 0: plain LDA; read with kFixed
  double positive_prior = 0.0;  ///< P(label 1) in (0, 1), moves the threshold; 0: as in the samples
  int num_threads = 1;          ///< ≥ 1; changes no bit of the result
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("shrinkage_rule", NameOf(shrinkage_rule));
    visit("shrinkage", shrinkage);
    visit("positive_prior", positive_prior);
  }
};

enum class Termination : std::uint8_t {
  kNotRun,
  kSolved,
  kSingular,  ///< the pooled covariance has no inverse: there are no weights
};
[[nodiscard]] std::string_view NameOf(Termination termination) noexcept;

struct Summary {
  Termination termination = Termination::kNotRun;
  std::string message = "TrainLda was not called";  ///< what happened
  std::string advice = {};  ///< which options to change; empty when there is a result
  std::size_t num_samples = 0;
  std::size_t num_positive = 0;
  double shrinkage = 0.0;             ///< λ used
  double positive_prior = 0.0;        ///< used
  double reciprocal_condition = 0.0;  ///< of the shrunk correlation
  double deviance = 0.0;       ///< −2 log-likelihood of the labels, on the training samples
  double null_deviance = 0.0;  ///< the same of the class shares alone
  std::vector<std::size_t> constant_features;  ///< weight 0
};

/// P(label 1 | x) = 1 / (1 + e^−z), z = intercept + Σ weights[j] · x[j]: on raw features, the same
/// form as logistic regression gives.
struct Result {
  std::vector<double> weights;
  double intercept = 0.0;
  std::vector<double> feature_mean;   ///< of all samples
  std::vector<double> feature_scale;  ///< standard deviation within classes; 1 for a constant
  Summary summary;
};

/// Linear discriminant analysis of two classes, normal with means m₀, m₁ and one covariance Σ:
///   w = Σ⁻¹(m₁ − m₀),  intercept = −wᵀ(m₀ + m₁)/2 + ln(π₁/π₀),
///   Σ = D((1 − λ)R + λI)D · n/(n − 2),  R the pooled correlation, D the scales (divisor n).
/// w is also Fisher's direction, along which between-class over within-class scatter is largest.
/// `labels`: 0 or 1, num_samples long. X is read in place, in blocks, at most three times; memory
/// above it is at most twelve matrices of num_features². Throws Error(kBadInput) for no samples,
/// one class alone, labels other than 0/1, fewer than three samples, or numbers that are not finite
/// (row and column named). A singular covariance is a result, not an exception.
/// Deterministic: same input, same bits, for every number of threads, on one machine.
/// Source: Fisher 1936; Hastie, Tibshirani and Friedman 2009, sec. 4.3, Eq. (4.9); dissertation
/// section 3.1.4; docs/methods/linear_discriminant_analysis.md.
template <class T>
[[nodiscard]] Result TrainLda(const DesignMatrix<T>& X,
                              std::span<const std::uint8_t> labels,
                              const Options& options = {});

extern template Result TrainLda(const DesignMatrix<float>&,
                                std::span<const std::uint8_t>,
                                const Options&);
extern template Result TrainLda(const DesignMatrix<double>&,
                                std::span<const std::uint8_t>,
                                const Options&);

}  // namespace handcraft::lda
