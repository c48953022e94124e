// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/column_moments.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "lib/core/parallel.h"
#include "trainers/logistic_irls/row_kernels.h"

namespace handcraft::logistic {
namespace {

struct ChunkSums {
  std::vector<double> sum;             // of x − first row
  std::vector<double> sum_of_squares;  // of x − first row
};

template <class T>
[[noreturn]] void ThrowAboutColumn(const DesignMatrix<T>& X, std::size_t column) {
  for (std::size_t i = 0; i < X.num_samples; ++i) {
    const T value = X.Row(i)[column];
    if (!std::isfinite(value)) {
      throw Error({.kind = Error::Kind::kBadInput,
                   .reason = fmt::format("row {}, column {} (counted from 0) is {}: a feature must "
                                         "be a finite number",
                                         i,
                                         column,
                                         value),
                   .remedy = "leave the row out or repair the feature"});
    }
  }
  throw Error({.kind = Error::Kind::kBadInput,
               .reason = fmt::format("column {} (counted from 0) has a spread whose square double "
                                     "cannot hold",
                                     column),
               .remedy = "multiply the column by a constant that brings it near 1"});
}

template <class T>
void CheckFinite(const DesignMatrix<T>& X, const std::vector<ChunkSums>& chunks) {
  for (const ChunkSums& chunk : chunks) {
    for (std::size_t j = 0; j < X.num_features; ++j) {
      if (!std::isfinite(chunk.sum[j]) || !std::isfinite(chunk.sum_of_squares[j])) {
        ThrowAboutColumn(X, j);
      }
      // A difference so small that its square vanished.
      if (chunk.sum[j] != 0.0 && !std::isnormal(chunk.sum_of_squares[j])) ThrowAboutColumn(X, j);
    }
  }
}

// Mean and sum of squares about it of all rows up to the end of one chunk after the other.
template <class T>
ColumnMoments Merge(const DesignMatrix<T>& X,
                    const std::vector<ChunkSums>& chunks,
                    std::size_t rows_per_chunk) {
  ColumnMoments moments{.mean = std::vector<double>(X.num_features, 0.0),
                        .scale = std::vector<double>(X.num_features, 0.0)};
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const std::size_t begin = c * rows_per_chunk;
    const auto before = static_cast<double>(begin);
    const auto count = static_cast<double>(std::min(rows_per_chunk, X.num_samples - begin));
    const T* first = X.Row(begin);
    for (std::size_t j = 0; j < X.num_features; ++j) {
      const double offset = chunks[c].sum[j] / count;  // mean of the chunk − its first row
      const double squares = std::max(0.0, chunks[c].sum_of_squares[j] - offset * chunks[c].sum[j]);
      const double chunk_mean = static_cast<double>(first[j]) + offset;
      const double difference = c == 0 ? 0.0 : chunk_mean - moments.mean[j];
      moments.mean[j] =
          c == 0 ? chunk_mean : moments.mean[j] + difference * (count / (before + count));
      moments.scale[j] += squares + difference * difference * (before * count / (before + count));
    }
  }
  for (double& scale : moments.scale) {
    scale = scale > 0.0 ? std::sqrt(scale / static_cast<double>(X.num_samples)) : 1.0;
  }
  return moments;
}

}  // namespace

std::size_t RowsPerChunk(std::size_t num_rows) noexcept {
  constexpr std::size_t kMinRows = 512;
  constexpr std::size_t kMaxChunks = 256;
  const std::size_t wanted = (num_rows + kMaxChunks - 1) / kMaxChunks;
  return std::max(kMinRows, (wanted + kTileRows - 1) / kTileRows * kTileRows);
}

template <class T>
ColumnMoments ComputeColumnMoments(const DesignMatrix<T>& X, int num_threads) {
  const std::size_t rows_per_chunk = RowsPerChunk(X.num_samples);
  std::vector<ChunkSums> chunks((X.num_samples + rows_per_chunk - 1) / rows_per_chunk);
  ParallelFor(chunks.size(), num_threads, [&](std::size_t c) {
    const std::size_t begin = c * rows_per_chunk;
    const std::size_t end = std::min(begin + rows_per_chunk, X.num_samples);
    const std::vector<double> first(X.Row(begin), X.Row(begin) + X.num_features);
    ChunkSums& sums = chunks[c];
    sums.sum.assign(X.num_features, 0.0);
    sums.sum_of_squares.assign(X.num_features, 0.0);
    const ColumnScaling about{.num_features = X.num_features, .mean = first.data()};
    for (std::size_t i = begin; i < end; ++i) {
      AddMoments(X.Row(i), about, sums.sum.data(), sums.sum_of_squares.data());
    }
  });
  CheckFinite(X, chunks);
  return Merge(X, chunks, rows_per_chunk);
}

template ColumnMoments ComputeColumnMoments(const DesignMatrix<float>&, int);
template ColumnMoments ComputeColumnMoments(const DesignMatrix<double>&, int);

}  // namespace handcraft::logistic
