// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace handcraft {

/// A = Σ_k values[k] v_k v_kᵀ.
struct SymmetricEigen {
  std::vector<double> values;   ///< descending
  std::vector<double> vectors;  ///< row-major: row k is v_k, of length 1

  [[nodiscard]] std::span<const double> Vector(std::size_t k) const noexcept {
    return std::span(vectors).subspan(k * values.size(), values.size());
  }
};

/// Eigenvalues and eigenvectors of a symmetric size × size matrix, of which the lower triangle is
/// read, by LAPACK's dsyevd (divide and conquer). The entry of each vector that is largest in
/// magnitude (the first of equals, to 1e-9) is positive, so that signs do not depend on the
/// library. BLAS works on one thread: same input, same bits. Memory: three such matrices.
/// Throws std::logic_error unless the size fits and every number is finite; Error(kNoResult) when
/// LAPACK does not converge.
[[nodiscard]] SymmetricEigen EigenDecompose(std::vector<double> matrix, std::size_t size);

}  // namespace handcraft
