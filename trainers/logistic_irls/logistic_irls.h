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

namespace handcraft::logistic {

using handcraft::DesignMatrix;

/// Arithmetic of the Hessian. Gradient and deviance are always double, so the optimum is the same.
enum class HessianPrecision { kAuto, kSingle, kDouble };
[[nodiscard]] std::string_view NameOf(HessianPrecision precision) noexcept;

struct Options {
  double ridge =
      0.0;  ///< λ ≥ 0 in deviance/2 + λ/2·‖w‖², w on standardised features, intercept free
  int max_iterations = 100;          ///< steps in all, ≥ 1
  double gradient_tolerance = 1e-9;  ///< ‖∇‖∞ / num_samples ≤ this (standardised features)
  double relative_deviance_tolerance = 1e-12;  ///< |D − D_previous| ≤ this · (|D| + 0.1)
  HessianPrecision hessian_precision = HessianPrecision::kAuto;
  double warm_start_share = 0.1;  ///< first steps take their Hessian from this share of the samples
                                  ///< (gradients are always of all); 0: never
  std::vector<double> initial_weights = {};  ///< on raw features; where to begin, such as the fit
                                             ///< of similar data; empty: at the intercept alone
  double initial_intercept = 0.0;            ///< read with initial_weights
  bool standard_errors = true;
  int num_threads = 1;     ///< ≥ 1; does not change a bit of the result
  std::uint64_t seed = 1;  ///< draws the warm start's samples
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("ridge", ridge);
    visit("max_iterations", max_iterations);
    visit("gradient_tolerance", gradient_tolerance);
    visit("relative_deviance_tolerance", relative_deviance_tolerance);
    visit("hessian_precision", NameOf(hessian_precision));
    visit("warm_start_share", warm_start_share);
    visit("seed", seed);
  }
};

enum class Termination {
  kNotRun,
  kConverged,
  kIterationLimit,
  kSeparated,         ///< completely or quasi-completely: some weights would grow for ever
  kRankDeficient,     ///< some features are linear combinations of others (listed); ridge is 0
  kNumericalFailure,  ///< no step lowers the deviance any more, far from the optimum
};
[[nodiscard]] std::string_view NameOf(Termination termination) noexcept;

struct Summary {
  Termination termination = Termination::kNotRun;
  std::string message = "TrainLogistic was not called";  ///< what happened
  std::string advice = {};        ///< which options to change; empty when there is an optimum
  int iterations = 0;             ///< steps taken, gradients always of all samples
  int warm_start_iterations = 0;  ///< how many of them with a Hessian from a share of the samples
  int step_halvings = 0;
  bool fell_back_to_double = false;
  double deviance = 0.0;              ///< −2 log-likelihood
  double null_deviance = 0.0;         ///< of the model with an intercept alone
  double aic = 0.0;                   ///< deviance + 2 · rank
  double gradient_norm = 0.0;         ///< ‖∇‖∞ / num_samples
  double reciprocal_condition = 0.0;  ///< of the Hessian at the end, standardised features
  std::size_t num_samples = 0;
  std::size_t num_positive = 0;
  std::size_t rank = 0;                       ///< intercept included
  std::vector<std::size_t> aliased_features;  ///< those left at zero when rank deficient
};

/// Weights act on raw features: z = intercept + Σ weights[j] · x[j].
struct Result {
  std::vector<double> weights;
  double intercept = 0.0;
  std::vector<double> standard_errors;  ///< of weights; NaN where aliased; empty when not asked
                                        ///< for, or when there is no optimum to take them at
  double intercept_standard_error = 0.0;
  std::vector<double> feature_mean;   ///< the standardisation that is folded in
  std::vector<double> feature_scale;  ///< standard deviation; 1 for a constant feature
  Summary summary;
};

/// Maximum-likelihood logistic regression by iteratively reweighted least squares (Newton):
///   θ* = argmax Π_i P(z_i | x_i; θ),  θ ← θ + (XᵀWX + λI)⁻¹ (Xᵀ(z − p) − λθ),  W = diag(p(1 − p)).
/// `labels`: 0 or 1, num_samples long. X is read in place, block by block, several times; extra
/// memory is O(num_features² + blocks). Throws Error(kBadInput) for no samples, one class alone,
/// labels other than 0/1, or numbers that are not finite (row and column named), std::logic_error
/// for initial weights that are not one finite number a feature. Not converging is a result, not an
/// exception. Where the descent begins does not change the optimum, beyond rounding.
/// Deterministic: same input, same bits, for every number of threads, on one machine.
/// Source: dissertation Eq. (3.1); McCullagh and Nelder 1989, sec. 2.5;
/// docs/methods/logistic_regression.md.
template <class T>
[[nodiscard]] Result TrainLogistic(const DesignMatrix<T>& X,
                                   std::span<const std::uint8_t> labels,
                                   const Options& options = {});

extern template Result TrainLogistic(const DesignMatrix<float>&,
                                     std::span<const std::uint8_t>,
                                     const Options&);
extern template Result TrainLogistic(const DesignMatrix<double>&,
                                     std::span<const std::uint8_t>,
                                     const Options&);

}  // namespace handcraft::logistic
