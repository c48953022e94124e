// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

namespace handcraft::logistic {

/// Rows handled together, so that a row read from memory is used twice while it is in the cache.
inline constexpr std::size_t kTileRows = 8;

/// Pointers to the rows of a tile. A short tile repeats its last row with factor 0.
template <class T>
using RowTile = std::array<const T*, kTileRows>;

/// The columns' centres and a factor a column, num_features long each.
struct ColumnScaling {
  std::size_t num_features = 0;
  const double* mean = nullptr;
  const double* factor = nullptr;
};

/// scores[i] = Σ_j factor[j] · (x_ij − mean[j]), in double, for the eight rows of the tile.
///
/// These kernels sum in one written order whatever the processor (four lanes, then the tail), with
/// one rounding an operation, so AVX2 and baseline versions give the same bits; the best one is
/// chosen when the program starts. They allocate nothing and may run on many threads.
void ComputeScores(const RowTile<float>& rows, const ColumnScaling& scaling, double* scores);
void ComputeScores(const RowTile<double>& rows, const ColumnScaling& scaling, double* scores);

/// sum[j] += Σ_i row_factors[i] · (x_ij − mean[j]); scaling.factor is not used.
void AddWeightedRows(const RowTile<float>& rows,
                     const ColumnScaling& scaling,
                     const double* row_factors,
                     double* sum);
void AddWeightedRows(const RowTile<double>& rows,
                     const ColumnScaling& scaling,
                     const double* row_factors,
                     double* sum);

/// out[j] = row_factor · factor[j] · (x_j − mean[j]).
void StandardiseRow(const float* row, const ColumnScaling& scaling, double row_factor, float* out);
void StandardiseRow(const float* row, const ColumnScaling& scaling, double row_factor, double* out);
void StandardiseRow(const double* row, const ColumnScaling& scaling, double row_factor, float* out);
void StandardiseRow(const double* row,
                    const ColumnScaling& scaling,
                    double row_factor,
                    double* out);

/// With d = x_j − mean[j]: sum[j] += d and sum_of_squares[j] += d²; scaling.factor is not used.
void AddMoments(const float* row,
                const ColumnScaling& scaling,
                double* sum,
                double* sum_of_squares);
void AddMoments(const double* row,
                const ColumnScaling& scaling,
                double* sum,
                double* sum_of_squares);

}  // namespace handcraft::logistic
