// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/similarity.h"

#include <algorithm>
#include <cmath>

namespace handcraft::features {
namespace {

double Power(double base, int exponent) noexcept {
  double power = 1.0;
  for (; exponent > 0; exponent /= 2) {
    if (exponent % 2 == 1) power *= base;
    base *= base;
  }
  return power;
}

}  // namespace

std::string_view NameOf(SimilarityType type) noexcept {
  switch (type) {
    case SimilarityType::kLinear:
      return "linear";
    case SimilarityType::kPolynomial:
      return "poly";
    case SimilarityType::kRbf:
      return "rbf";
  }
  return "unknown";
}

double Similarity::operator()(double inner,
                              double squared_norm_a,
                              double squared_norm_b) const noexcept {
  switch (type) {
    case SimilarityType::kLinear:
      return inner;
    case SimilarityType::kPolynomial:
      return Power(gamma * inner + coef0, degree);
    case SimilarityType::kRbf:
      // Rounding must not make a distance negative.
      return std::exp(-gamma * std::max(0.0, squared_norm_a + squared_norm_b - 2.0 * inner));
  }
  return 0.0;
}

}  // namespace handcraft::features
