// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::logistic {

/// Centre and spread of every column.
struct ColumnMoments {
  std::vector<double> mean;
  std::vector<double> scale;  ///< standard deviation (divisor num_samples); 1 when constant
};

/// One pass over X. Chunks of rows are summed about their own first row and merged in order (Chan,
/// Golub and LeVeque 1983, Eq. (2.1)), so that a mean far from zero costs no digits and the number
/// of threads changes nothing. A constant column has exactly its value as mean.
/// Throws Error(kBadInput) naming row and column (from 0) of the first number that is not finite,
/// or the column whose spread is beyond double's range when squared.
template <class T>
[[nodiscard]] ColumnMoments ComputeColumnMoments(const DesignMatrix<T>& X, int num_threads);

extern template ColumnMoments ComputeColumnMoments(const DesignMatrix<float>&, int);
extern template ColumnMoments ComputeColumnMoments(const DesignMatrix<double>&, int);

/// Rows a task takes: a multiple of kTileRows that depends on num_rows alone, at most 256 tasks.
[[nodiscard]] std::size_t RowsPerChunk(std::size_t num_rows) noexcept;

}  // namespace handcraft::logistic
