// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace handcraft::svm {

/// Part of a Gram (kernel) matrix, symmetric, in the caller's memory.
struct KernelView {
  const double* data = nullptr;
  std::size_t size = 0;
  std::size_t stride = 0;  ///< numbers from one row to the next, ≥ size

  [[nodiscard]] const double* Row(std::size_t i) const noexcept { return data + i * stride; }
};

struct SmoOptions {
  double tolerance = 1e-3;  ///< ε > 0: largest violation of the KKT conditions at the end
  std::size_t max_iterations = 10000000;  ///< steps of two coefficients; ≥ 1

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

struct SmoResult {
  std::vector<double> coefficients;  ///< β, one a sample; 0 for those that support nothing
  double intercept = 0.0;            ///< b
  double objective = 0.0;            ///< Σ y β − βᵀKβ / 2
  double violation = 0.0;  ///< max over I_up − min over I_low of the gradient at the end
  std::size_t iterations = 0;
  bool converged = false;  ///< violation < ε; false: max_iterations were not enough
};

/// One two-class support vector machine, f(x) = Σ_i β_i K(x_i, x) + b:
///   max_β  Σ_i y_i β_i − βᵀKβ / 2   subject to   Σ_i β_i = 0,  0 ≤ y_i β_i ≤ C_i,
/// by sequential minimal optimisation. In every step the first sample i violates the KKT conditions
/// most and the second promises, by second-order information, the largest gain; ties go to the
/// last, as in libsvm, whose steps these are (without shrinking). β_i is libsvm's y_i α_i, b its
/// −ρ: the mean of the gradient over 0 < |β_i| < C_i, or the middle of its bounds when there is
/// none.
///
/// `y` holds 1 and −1, `limits` the C_i ≥ 0. A sample with C_i = 0 takes no part: all others get
/// the bits that they get without it. O(size) memory and O(size) time an iteration; deterministic;
/// thread-safe. Throws std::logic_error when sizes do not fit.
/// Source: Fan, Chen and Lin 2005, "Working set selection using second order information for
/// training support vector machines", algorithm 2 (WSS 2); Chang and Lin 2011, "LIBSVM",
/// sections 4.1, 4.1.5.
[[nodiscard]] SmoResult SolveDual(const KernelView& kernel,
                                  std::span<const double> y,
                                  std::span<const double> limits,
                                  const SmoOptions& options = {});

}  // namespace handcraft::svm
