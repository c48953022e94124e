// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/symmetric_eigen.h"

#include <lapacke.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/linear_algebra/single_threaded_blas.h"

namespace handcraft {
namespace {

constexpr double kEqual = 1e-9;

void MakeSignDefinite(std::span<double> vector) {
  double largest = 0.0;
  for (const double entry : vector) largest = std::max(largest, std::abs(entry));
  const auto first = std::find_if(vector.begin(), vector.end(), [&](double entry) {
    return std::abs(entry) >= largest * (1.0 - kEqual);
  });
  if (first == vector.end() || *first >= 0.0) return;
  for (double& entry : vector) entry = -entry;
}

}  // namespace

SymmetricEigen EigenDecompose(std::vector<double> matrix, std::size_t size) {
  HC_CHECK(size >= 1 && matrix.size() == size * size, size, matrix.size());
  HC_CHECK(std::all_of(matrix.begin(), matrix.end(), [](double x) { return std::isfinite(x); }),
           size);
  const SingleThreadedBlas single_threaded_blas;
  SymmetricEigen eigen{.values = std::vector<double>(size), .vectors = std::move(matrix)};
  const auto n = static_cast<lapack_int>(size);
  // The lower triangle of a row-major matrix is the upper one of the same numbers column by column.
  const lapack_int info =
      LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'U', n, eigen.vectors.data(), n, eigen.values.data());
  HC_CHECK(info >= 0, info);
  if (info > 0) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = fmt::format("LAPACK's dsyevd did not converge (info {})", info)});
  }
  // Ascending, a vector a column: in memory row k is vector k.
  std::reverse(eigen.values.begin(), eigen.values.end());
  for (std::size_t k = 0; k < size / 2; ++k) {
    const auto row = [&](std::size_t r) {
      return eigen.vectors.begin() + static_cast<std::ptrdiff_t>(r * size);
    };
    std::swap_ranges(row(k), row(k + 1), row(size - 1 - k));
  }
  for (std::size_t k = 0; k < size; ++k) {
    MakeSignDefinite(std::span(eigen.vectors).subspan(k * size, size));
  }
  return eigen;
}

}  // namespace handcraft
