// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace handcraft {

/// x of A x = b, and how far A is from singular.
struct PositiveDefiniteSolution {
  std::vector<double> x;
  double reciprocal_condition = 0.0;  ///< 1 / (‖A‖₁ ‖A⁻¹‖₁), estimated
};

/// Solves A x = b for a symmetric positive definite size × size matrix, of which the lower triangle
/// is read, by LAPACK's Cholesky factorisation. Nothing when A is not positive definite, or when
/// its reciprocal condition is below size · 2⁻⁵², so that no digit of x would hold. BLAS works on
/// one thread: same input, same bits. Throws std::logic_error unless the sizes fit and every number
/// is finite.
[[nodiscard]] std::optional<PositiveDefiniteSolution> SolvePositiveDefinite(
    std::vector<double> matrix, std::vector<double> right_side);

}  // namespace handcraft
