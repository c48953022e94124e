// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/positive_definite.h"

#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lib/core/check.h"
#include "lib/linear_algebra/single_threaded_blas.h"

namespace handcraft {

std::optional<PositiveDefiniteSolution> SolvePositiveDefinite(std::vector<double> matrix,
                                                              std::vector<double> right_side) {
  const std::size_t size = right_side.size();
  const auto is_finite = [](double x) { return std::isfinite(x); };
  HC_CHECK(size >= 1 && matrix.size() == size * size, size, matrix.size());
  HC_CHECK(std::all_of(matrix.begin(), matrix.end(), is_finite), size);
  HC_CHECK(std::all_of(right_side.begin(), right_side.end(), is_finite), size);
  const SingleThreadedBlas single_threaded_blas;
  const auto n = static_cast<lapack_int>(size);
  // The lower triangle of a row-major matrix is the upper one of the same numbers column by column.
  const double norm = LAPACKE_dlansy(LAPACK_COL_MAJOR, '1', 'U', n, matrix.data(), n);
  if (LAPACKE_dpotrf(LAPACK_COL_MAJOR, 'U', n, matrix.data(), n) != 0) return std::nullopt;
  PositiveDefiniteSolution solution{.x = std::move(right_side)};
  const lapack_int info = LAPACKE_dpocon(
      LAPACK_COL_MAJOR, 'U', n, matrix.data(), n, norm, &solution.reciprocal_condition);
  HC_CHECK(info == 0, info);
  const double smallest = static_cast<double>(size) * std::numeric_limits<double>::epsilon();
  if (!(solution.reciprocal_condition > smallest)) return std::nullopt;
  static_cast<void>(
      LAPACKE_dpotrs(LAPACK_COL_MAJOR, 'U', n, 1, matrix.data(), n, solution.x.data(), n));
  return solution;
}

}  // namespace handcraft
