// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/lda/ledoit_wolf.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "lib/core/parallel.h"

namespace handcraft::lda {
namespace {

// Σ_i ‖z_i‖⁴.
template <class T>
double SumOfFourthPowers(const DesignMatrix<T>& X,
                         std::span<const std::uint8_t> labels,
                         const Scatter& scatter,
                         std::span<const double> scale,
                         int num_threads) {
  constexpr std::size_t kRowsPerBlock = 1024;
  std::vector<double> inverse(scale.size());
  std::transform(scale.begin(), scale.end(), inverse.begin(), [](double s) {
    return s > 0.0 ? 1.0 / s : 0.0;
  });
  std::vector<double> sums((X.num_samples + kRowsPerBlock - 1) / kRowsPerBlock, 0.0);
  ParallelFor(sums.size(), num_threads, [&](std::size_t block) {
    const std::size_t end = std::min(X.num_samples, (block + 1) * kRowsPerBlock);
    for (std::size_t i = block * kRowsPerBlock; i < end; ++i) {
      const std::span<const double> mean = scatter.Mean(labels[i]);
      double square = 0.0;
      for (std::size_t j = 0; j < X.num_features; ++j) {
        const double z = (static_cast<double>(X.Row(i)[j]) - mean[j]) * inverse[j];
        square += z * z;
      }
      sums[block] += square * square;
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}  // namespace

template <class T>
double LedoitWolfShare(const DesignMatrix<T>& X,
                       std::span<const std::uint8_t> labels,
                       const Scatter& scatter,
                       std::span<const double> scale,
                       int num_threads) {
  const std::size_t p = X.num_features;
  const auto n = static_cast<double>(X.num_samples);
  double norm = 0.0;      // ‖R‖²
  double distance = 0.0;  // ‖R − I‖²
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      if (!(scale[i] > 0.0) || !(scale[j] > 0.0)) continue;
      const double r = scatter.products[i * p + j] / (n * scale[i] * scale[j]);
      norm += r * r;
      distance += (r - (i == j ? 1.0 : 0.0)) * (r - (i == j ? 1.0 : 0.0));
    }
  }
  const double fourth = SumOfFourthPowers(X, labels, scatter, scale, num_threads);
  const double error = std::max(0.0, (fourth / n - norm) / n);
  return error >= distance ? (distance > 0.0 ? 1.0 : 0.0) : error / distance;
}

template double LedoitWolfShare(const DesignMatrix<float>&,
                                std::span<const std::uint8_t>,
                                const Scatter&,
                                std::span<const double>,
                                int);
template double LedoitWolfShare(const DesignMatrix<double>&,
                                std::span<const std::uint8_t>,
                                const Scatter&,
                                std::span<const double>,
                                int);

}  // namespace handcraft::lda
