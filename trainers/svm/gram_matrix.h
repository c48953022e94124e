// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/core/progress.h"
#include "lib/features/inner_products.h"
#include "lib/features/similarity.h"
#include "trainers/svm/smo.h"

namespace handcraft::svm {

/// (x − mean) / scale, feature by feature; both empty: samples are taken as they are.
struct Normaliser {
  std::vector<double> mean;
  std::vector<double> scale;  ///< all > 0
};

/// Mean and standard deviation (divisor n) of every column; the scale of a constant column is 1.
template <class T>
[[nodiscard]] Normaliser FitNormaliser(const DesignMatrix<T>& X);
extern template Normaliser FitNormaliser(const DesignMatrix<float>&);
extern template Normaliser FitNormaliser(const DesignMatrix<double>&);

/// Samples as kernels see them: normalised, ordered by class, filled up with zeros.
struct Samples {
  std::vector<double> values;  ///< num_samples × stride
  std::size_t num_features = 0;
  std::size_t stride = 0;         ///< features::PaddedLength(num_features)
  std::vector<std::size_t> rows;  ///< the row of X that each sample is; ascending in a class
  std::vector<std::size_t>
      class_begins;               ///< num_classes + 1: class c is [begins[c], begins[c + 1])
  bool single_precision = false;  ///< every value is a float's

  [[nodiscard]] std::size_t NumSamples() const noexcept { return rows.size(); }
  [[nodiscard]] std::size_t NumClasses() const noexcept { return class_begins.size() - 1; }
  [[nodiscard]] std::span<const double> Sample(std::size_t i) const noexcept {
    return std::span(values).subspan(i * stride, num_features);
  }
  [[nodiscard]] std::size_t ClassOf(std::size_t sample) const noexcept;
};

/// `classes`: a number from 0 a row of X; floats are normalised in double and rounded to float
/// again. Throws Error(kBadInput) for no columns, fewer than two classes, a number below the
/// largest that no row has, and for the first number that is not finite (row and column named);
/// std::logic_error when sizes do not fit.
template <class T>
[[nodiscard]] Samples PrepareSamples(const DesignMatrix<T>& X,
                                     std::span<const std::uint32_t> classes,
                                     const Normaliser& normaliser);
extern template Samples PrepareSamples(const DesignMatrix<float>&,
                                       std::span<const std::uint32_t>,
                                       const Normaliser&);
extern template Samples PrepareSamples(const DesignMatrix<double>&,
                                       std::span<const std::uint32_t>,
                                       const Normaliser&);

/// A symmetric matrix with a row and a column a sample.
struct SampleMatrix {
  std::vector<double> values;
  std::size_t size = 0;

  [[nodiscard]] const double* Row(std::size_t i) const noexcept { return values.data() + i * size; }
  [[nodiscard]] KernelView View(std::size_t begin, std::size_t end) const noexcept {
    return {.data = Row(begin) + begin, .size = end - begin, .stride = size};
  }
};

/// The most bytes a matrix of samples may take: 16384 samples.
inline constexpr std::size_t kMaxMatrixBytes = std::size_t{2} << 30;

/// x_iᵀ x_k of all samples, once for every kernel function, pair of classes and fold. In blocks of
/// rows that stay in the second-level cache; an entry's bits depend on its two samples alone, so
/// that neither other samples nor the number of threads change it. Throws Error(kBadInput) when
/// there are too many samples for kMaxMatrixBytes.
[[nodiscard]] SampleMatrix ComputeInnerProducts(const Samples& samples,
                                                int num_threads,
                                                const Progress& progress = {});

/// The Gram matrix K(x_i, x_k) from the inner products. Throws Error(kBadInput) naming two rows of
/// X whose kernel value is not finite.
[[nodiscard]] SampleMatrix ComputeGram(const SampleMatrix& inner_products,
                                       const features::Similarity& similarity,
                                       const Samples& samples,
                                       int num_threads);

}  // namespace handcraft::svm
