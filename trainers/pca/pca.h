// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/core/progress.h"
#include "lib/linear_algebra/scatter.h"

namespace handcraft::pca {

/// What a column is divided by, after its mean was taken off.
enum class Scaling : std::uint8_t {
  kNone,      ///< nothing: eigenvectors of the covariance, as in the dissertation
  kStandard,  ///< its standard deviation: eigenvectors of the correlation
};
[[nodiscard]] std::string_view NameOf(Scaling scaling) noexcept;

struct Options {
  Scaling scaling = Scaling::kNone;
  ScatterPrecision precision = ScatterPrecision::kDouble;  ///< of products within a block of rows
  int num_threads = 1;                                     ///< ≥ 1; changes no bit of the result
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("scaling", NameOf(scaling));
    visit("precision", NameOf(precision));
  }
};

/// Component k of a row x is Σ_j components[k][j] · (x[j] − mean[j]) / scale[j].
struct Result {
  std::size_t num_samples = 0;
  std::size_t num_features = 0;
  std::vector<double> mean;
  std::vector<double> scale;        ///< 1 without scaling, and for a constant column
  std::vector<double> eigenvalues;  ///< descending, ≥ 0: the variances of the components
  std::vector<double> components;  ///< row-major num_features × num_features, rows of length 1; in
                                   ///< each the entry largest in magnitude is positive

  [[nodiscard]] std::span<const double> Component(std::size_t k) const noexcept {
    return std::span(components).subspan(k * num_features, num_features);
  }
  [[nodiscard]] double TotalVariance() const noexcept;
  /// How many components hold at least this share, in (0, 1], of the total variance (the
  /// dissertation's energy); 0 when nothing varies.
  [[nodiscard]] std::size_t NumComponentsFor(double share) const;
};

/// Principal components of the rows of X: eigenvectors of C = Σ (x − m)(x − m)ᵀ / (n − 1), or of
/// the correlation, by LAPACK. The covariance is exact: every row counts, means are removed
/// (lib/linear_algebra/scatter.h); nothing is drawn at random.
/// X is read in place, in blocks; memory above it is at most fourteen matrices of num_features².
/// Throws Error(kBadInput) for fewer than two rows, no columns, or a number that is not finite (row
/// and column named). Same input, same bits, for every number of threads, on one machine.
/// Source: Pearson 1901; dissertation section 3.2.1; docs/methods/feature_analysis.md.
template <class T>
[[nodiscard]] Result TrainPca(const DesignMatrix<T>& X, const Options& options = {});

extern template Result TrainPca(const DesignMatrix<float>&, const Options&);
extern template Result TrainPca(const DesignMatrix<double>&, const Options&);

/// The same from a scatter of one group that is there already, each column divided by a scale > 0
/// of the caller's choice. Throws std::logic_error when sizes do not fit.
[[nodiscard]] Result PcaOfScatter(const Scatter& scatter, std::span<const double> scale);

/// Standard deviations of the columns (divisor n − 1); 1 for a constant column.
[[nodiscard]] std::vector<double> StandardDeviations(const Scatter& scatter);

}  // namespace handcraft::pca
