// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/core/design_matrix.h"
#include "trainers/svm/cross_validation.h"
#include "trainers/svm/gram_matrix.h"
#include "trainers/svm/svm.h"

namespace handcraft::svm {

/// Values that a search tries. Those a kernel does not read are tried once: a linear kernel has no
/// gamma, and only the polynomial has degree and coef0.
struct Grid {
  std::vector<features::SimilarityType> kernels = {features::SimilarityType::kPolynomial};
  std::vector<int> degrees = {3};
  std::vector<double> gammas = {0.0};  ///< 0: 1 / num_features
  std::vector<double> coef0s = {0.0};
  std::vector<double> penalties = {1.0};

  /// Every combination, the last list quickest; the rest is as in `base`. Throws Error(kUsage) for
  /// an empty list or a value out of range.
  [[nodiscard]] std::vector<Options> Combinations(const Options& base) const;
};

struct GridPoint {
  Options options;
  CrossValidation validation;
};

struct GridSearch {
  std::vector<GridPoint> points;  ///< in the order of Grid::Combinations
  std::size_t best = 0;           ///< most correct; of equal ones the first
};

/// Cross-validates every combination of the grid on the same folds, over one matrix of inner
/// products. Throws as Grid::Combinations, ComputeGram and CrossValidate do. The number of threads
/// changes no bit.
[[nodiscard]] GridSearch SearchGrid(const SampleMatrix& inner_products,
                                    const Samples& samples,
                                    std::span<const std::uint32_t> folds,
                                    const Grid& grid,
                                    const Options& base = {});

/// The same from rows: prepares samples (standardised if `base` says so; the normaliser is that of
/// all rows) and their inner products. Throws as PrepareSamples and ComputeInnerProducts do
/// besides.
template <class T>
[[nodiscard]] GridSearch SearchGridOfRows(const DesignMatrix<T>& X,
                                          std::span<const std::uint32_t> classes,
                                          std::span<const std::uint32_t> folds,
                                          const Grid& grid,
                                          const Options& base = {});
extern template GridSearch SearchGridOfRows(const DesignMatrix<float>&,
                                            std::span<const std::uint32_t>,
                                            std::span<const std::uint32_t>,
                                            const Grid&,
                                            const Options&);
extern template GridSearch SearchGridOfRows(const DesignMatrix<double>&,
                                            std::span<const std::uint32_t>,
                                            std::span<const std::uint32_t>,
                                            const Grid&,
                                            const Options&);

}  // namespace handcraft::svm
