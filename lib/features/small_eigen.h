// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

namespace handcraft::features {

/// A = Σ_k values[k] v_k v_kᵀ of a small symmetric matrix.
template <std::size_t N>
struct SmallEigen {
  std::array<double, N> values = {};                  ///< ascending
  std::array<std::array<double, N>, N> vectors = {};  ///< v_k, of length 1
};

/// Eigenvalues and eigenvectors of a symmetric N × N matrix, row-major, N 3 or 4, by cyclic Jacobi
/// rotations: vectors are orthogonal to rounding, also for equal eigenvalues. The entry of each
/// vector that is largest in magnitude (the first of equals) is positive. Numbers that are not
/// finite give numbers that are not finite. Does not allocate; thread-safe; the same bits with any
/// instructions. Source: Golub and Van Loan, "Matrix computations", 4th ed., section 8.5.
template <std::size_t N>
[[nodiscard]] SmallEigen<N> EigenOfSymmetric(const std::array<double, N * N>& matrix) noexcept;

extern template SmallEigen<3> EigenOfSymmetric<3>(const std::array<double, 9>&) noexcept;
extern template SmallEigen<4> EigenOfSymmetric<4>(const std::array<double, 16>&) noexcept;

}  // namespace handcraft::features
