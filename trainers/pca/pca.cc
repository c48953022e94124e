// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/pca/pca.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/linear_algebra/symmetric_eigen.h"

namespace handcraft::pca {

std::string_view NameOf(Scaling scaling) noexcept {
  return scaling == Scaling::kNone ? "none" : "standard";
}

void Options::Validate() const {
  RequireOption(num_threads >= 1, "pca::Options.num_threads", num_threads, ">= 1");
}

double Result::TotalVariance() const noexcept {
  return std::accumulate(eigenvalues.begin(), eigenvalues.end(), 0.0);
}

std::size_t Result::NumComponentsFor(double share) const {
  HC_CHECK(share > 0.0 && share <= 1.0, share);
  // The same sum in the same order: at share 1 the whole is reached at the last eigenvalue above 0.
  const double wanted = share * TotalVariance();
  double sum = 0.0;
  std::size_t count = 0;
  while (count < eigenvalues.size() && sum < wanted) sum += eigenvalues[count++];
  return count;
}

std::vector<double> StandardDeviations(const Scatter& scatter) {
  const std::size_t p = scatter.num_features;
  const auto divisor = static_cast<double>(scatter.NumRows() - scatter.num_rows.size());
  std::vector<double> deviations(p);
  for (std::size_t j = 0; j < p; ++j) {
    const double square = scatter.products[j * p + j];
    deviations[j] = square > 0.0 ? std::sqrt(square / divisor) : 1.0;
  }
  return deviations;
}

Result PcaOfScatter(const Scatter& scatter, std::span<const double> scale) {
  const std::size_t p = scatter.num_features;
  HC_CHECK(scatter.num_rows.size() == 1 && scatter.NumRows() >= 2, scatter.num_rows.size());
  HC_CHECK(scale.size() == p && scatter.products.size() == p * p, scale.size(), p);
  const auto divisor = static_cast<double>(scatter.NumRows() - 1);
  std::vector<double> covariance(scatter.products);
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      covariance[i * p + j] /= divisor * scale[i] * scale[j];
    }
  }
  SymmetricEigen eigen = EigenDecompose(std::move(covariance), p);
  for (double& value : eigen.values) value = std::max(0.0, value);  // rounding below zero
  return {.num_samples = scatter.NumRows(),
          .num_features = p,
          .mean = scatter.means,
          .scale = {scale.begin(), scale.end()},
          .eigenvalues = std::move(eigen.values),
          .components = std::move(eigen.vectors)};
}

template <class T>
Result TrainPca(const DesignMatrix<T>& X, const Options& options) {
  options.Validate();
  const Scatter scatter = ComputeScatter(X,
                                         {},
                                         1,
                                         {.precision = options.precision,
                                          .num_threads = options.num_threads,
                                          .progress = options.progress});
  if (scatter.NumRows() < 2) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "one sample has no variance",
                 .remedy = "give at least two samples"});
  }
  Report(options.progress, "eigenvectors", 0, 0);
  return PcaOfScatter(scatter,
                      options.scaling == Scaling::kStandard ? StandardDeviations(scatter)
                                                            : std::vector(X.num_features, 1.0));
}

template Result TrainPca(const DesignMatrix<float>&, const Options&);
template Result TrainPca(const DesignMatrix<double>&, const Options&);

}  // namespace handcraft::pca
