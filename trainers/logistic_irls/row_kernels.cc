// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/row_kernels.h"

#include <cstring>

// One source, compiled for AVX2 and for the baseline; the loader picks. Left out under sanitizers,
// whose start-up code must run before the loader's choice may.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define HC_FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#else
#define HC_FOR_EACH_PROCESSOR
#endif
#define HC_INLINE inline __attribute__((always_inline))

namespace handcraft::logistic {
namespace {

// Four lanes: one AVX2 register of doubles, and a float load that widens into it in one
// instruction.
constexpr std::size_t kLanes = 4;
using Float4 = float __attribute__((vector_size(16)));
using Double4 = double __attribute__((vector_size(32)));

// Written to a place, not returned: a 32-byte vector has no portable way to be returned. The lists
// of four conversions become one instruction; GCC 12 makes several of __builtin_convertvector.
HC_INLINE void Load(const double* from, Double4& to) { std::memcpy(&to, from, sizeof to); }
HC_INLINE void Load(const float* from, Double4& to) {
  to = Double4{static_cast<double>(from[0]),
               static_cast<double>(from[1]),
               static_cast<double>(from[2]),
               static_cast<double>(from[3])};
}
HC_INLINE void Store(const Double4& from, double* to) { std::memcpy(to, &from, sizeof from); }
HC_INLINE void Store(const Double4& from, float* to) {
  const Float4 narrow = {static_cast<float>(from[0]),
                         static_cast<float>(from[1]),
                         static_cast<float>(from[2]),
                         static_cast<float>(from[3])};
  std::memcpy(to, &narrow, sizeof narrow);
}

template <class T>
HC_INLINE void ScoresBody(const RowTile<T>& rows, const ColumnScaling& scaling, double* scores) {
  const std::size_t p = scaling.num_features;
  const std::size_t whole = p - p % kLanes;
  Double4 sums[kTileRows] = {};
  for (std::size_t j = 0; j < whole; j += kLanes) {
    Double4 mean;
    Double4 factor;
    Load(scaling.mean + j, mean);
    Load(scaling.factor + j, factor);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kTileRows; ++i) {
      Double4 x;
      Load(rows[i] + j, x);
      sums[i] += (x - mean) * factor;
    }
  }
#pragma GCC unroll 8
  for (std::size_t i = 0; i < kTileRows; ++i) {
    double sum = (sums[i][0] + sums[i][1]) + (sums[i][2] + sums[i][3]);
    for (std::size_t j = whole; j < p; ++j) {
      sum += (static_cast<double>(rows[i][j]) - scaling.mean[j]) * scaling.factor[j];
    }
    scores[i] = sum;
  }
}

template <class T>
HC_INLINE void WeightedRowsBody(const RowTile<T>& rows,
                                const ColumnScaling& scaling,
                                const double* row_factors,
                                double* sum) {
  const std::size_t p = scaling.num_features;
  const std::size_t whole = p - p % kLanes;
  for (std::size_t j = 0; j < whole; j += kLanes) {
    Double4 mean;
    Double4 total;
    Load(scaling.mean + j, mean);
    Load(sum + j, total);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < kTileRows; ++i) {
      Double4 x;
      Load(rows[i] + j, x);
      total += (x - mean) * row_factors[i];
    }
    Store(total, sum + j);
  }
  for (std::size_t j = whole; j < p; ++j) {
    for (std::size_t i = 0; i < kTileRows; ++i) {
      sum[j] += (static_cast<double>(rows[i][j]) - scaling.mean[j]) * row_factors[i];
    }
  }
}

template <class T, class Out>
HC_INLINE void StandardiseBody(const T* row,
                               const ColumnScaling& scaling,
                               double row_factor,
                               Out* out) {
  const std::size_t p = scaling.num_features;
  const std::size_t whole = p - p % kLanes;
  for (std::size_t j = 0; j < whole; j += kLanes) {
    Double4 x;
    Double4 mean;
    Double4 factor;
    Load(row + j, x);
    Load(scaling.mean + j, mean);
    Load(scaling.factor + j, factor);
    Store((x - mean) * factor * row_factor, out + j);
  }
  for (std::size_t j = whole; j < p; ++j) {
    out[j] = static_cast<Out>((static_cast<double>(row[j]) - scaling.mean[j]) * scaling.factor[j] *
                              row_factor);
  }
}

template <class T>
HC_INLINE void MomentsBody(const T* row,
                           const ColumnScaling& scaling,
                           double* sum,
                           double* sum_of_squares) {
  const std::size_t p = scaling.num_features;
  const std::size_t whole = p - p % kLanes;
  for (std::size_t j = 0; j < whole; j += kLanes) {
    Double4 x;
    Double4 mean;
    Double4 first;
    Double4 second;
    Load(row + j, x);
    Load(scaling.mean + j, mean);
    Load(sum + j, first);
    Load(sum_of_squares + j, second);
    const Double4 difference = x - mean;
    Store(first + difference, sum + j);
    Store(second + difference * difference, sum_of_squares + j);
  }
  for (std::size_t j = whole; j < p; ++j) {
    const double difference = static_cast<double>(row[j]) - scaling.mean[j];
    sum[j] += difference;
    sum_of_squares[j] += difference * difference;
  }
}

}  // namespace

HC_FOR_EACH_PROCESSOR
void ComputeScores(const RowTile<float>& rows, const ColumnScaling& scaling, double* scores) {
  ScoresBody(rows, scaling, scores);
}
HC_FOR_EACH_PROCESSOR
void ComputeScores(const RowTile<double>& rows, const ColumnScaling& scaling, double* scores) {
  ScoresBody(rows, scaling, scores);
}

HC_FOR_EACH_PROCESSOR
void AddWeightedRows(const RowTile<float>& rows,
                     const ColumnScaling& scaling,
                     const double* row_factors,
                     double* sum) {
  WeightedRowsBody(rows, scaling, row_factors, sum);
}
HC_FOR_EACH_PROCESSOR
void AddWeightedRows(const RowTile<double>& rows,
                     const ColumnScaling& scaling,
                     const double* row_factors,
                     double* sum) {
  WeightedRowsBody(rows, scaling, row_factors, sum);
}

HC_FOR_EACH_PROCESSOR
void StandardiseRow(const float* row, const ColumnScaling& scaling, double row_factor, float* out) {
  StandardiseBody(row, scaling, row_factor, out);
}
HC_FOR_EACH_PROCESSOR
void StandardiseRow(const float* row,
                    const ColumnScaling& scaling,
                    double row_factor,
                    double* out) {
  StandardiseBody(row, scaling, row_factor, out);
}
HC_FOR_EACH_PROCESSOR
void StandardiseRow(const double* row,
                    const ColumnScaling& scaling,
                    double row_factor,
                    float* out) {
  StandardiseBody(row, scaling, row_factor, out);
}
HC_FOR_EACH_PROCESSOR
void StandardiseRow(const double* row,
                    const ColumnScaling& scaling,
                    double row_factor,
                    double* out) {
  StandardiseBody(row, scaling, row_factor, out);
}

HC_FOR_EACH_PROCESSOR
void AddMoments(const float* row,
                const ColumnScaling& scaling,
                double* sum,
                double* sum_of_squares) {
  MomentsBody(row, scaling, sum, sum_of_squares);
}
HC_FOR_EACH_PROCESSOR
void AddMoments(const double* row,
                const ColumnScaling& scaling,
                double* sum,
                double* sum_of_squares) {
  MomentsBody(row, scaling, sum, sum_of_squares);
}

}  // namespace handcraft::logistic
