// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string_view>

namespace handcraft::features {

/// The similarity of two samples in a support vector machine. The numbers are libsvm's and stand in
/// model files.
enum class SimilarityType : std::uint8_t { kLinear = 0, kPolynomial = 1, kRbf = 2 };
[[nodiscard]] std::string_view NameOf(SimilarityType type) noexcept;

/// The kernel function K(a, b) of a support vector machine, from inner products:
///   linear aᵀb;  polynomial (γ aᵀb + c₀)^degree;  rbf exp(−γ(aᵀa + bᵀb − 2aᵀb)).
/// Powers are formed by repeated squaring, as libsvm does. (Named so because a kernel, in this
/// folder, is a filter's.) Source: Chang and Lin 2011, "LIBSVM", section 2.
struct Similarity {
  SimilarityType type = SimilarityType::kPolynomial;
  int degree = 3;      ///< of the polynomial, ≥ 1
  double gamma = 1.0;  ///< of polynomial and rbf, > 0
  double coef0 = 0.0;  ///< of the polynomial

  /// `inner` is aᵀb; the squared norms, aᵀa and bᵀb, are read by the rbf alone.
  [[nodiscard]] double operator()(double inner,
                                  double squared_norm_a,
                                  double squared_norm_b) const noexcept;
};

}  // namespace handcraft::features
