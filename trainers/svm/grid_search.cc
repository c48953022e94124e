// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/grid_search.h"

#include <string>
#include <utility>

#include "lib/core/option_rules.h"

namespace handcraft::svm {
namespace {

using features::SimilarityType;

template <class T>
std::vector<T> FirstOr(bool all, const std::vector<T>& values) {
  return all ? values : std::vector<T>{values.front()};
}

template <class T>
void RequireValues(const std::vector<T>& values, const std::string& name) {
  RequireOption(!values.empty(), "svm::Grid." + name + ".size", values.size(), "at least 1");
}

}  // namespace

std::vector<Options> Grid::Combinations(const Options& base) const {
  RequireValues(kernels, "kernels");
  RequireValues(degrees, "degrees");
  RequireValues(gammas, "gammas");
  RequireValues(coef0s, "coef0s");
  RequireValues(penalties, "penalties");
  std::vector<Options> combinations;
  Options options = base;
  for (const SimilarityType kernel : kernels) {
    options.kernel = kernel;
    const bool is_polynomial = kernel == SimilarityType::kPolynomial;
    for (const int degree : FirstOr(is_polynomial, degrees)) {
      options.degree = degree;
      for (const double gamma : FirstOr(kernel != SimilarityType::kLinear, gammas)) {
        options.gamma = gamma;
        for (const double coef0 : FirstOr(is_polynomial, coef0s)) {
          options.coef0 = coef0;
          for (const double penalty : penalties) {
            options.penalty = penalty;
            options.Validate();
            combinations.push_back(options);
          }
        }
      }
    }
  }
  return combinations;
}

GridSearch SearchGrid(const SampleMatrix& inner_products,
                      const Samples& samples,
                      std::span<const std::uint32_t> folds,
                      const Grid& grid,
                      const Options& base) {
  GridSearch search;
  const std::vector<Options> combinations = grid.Combinations(base);
  for (const Options& options : combinations) {
    Report(base.progress, "combinations", search.points.size(), combinations.size());
    const SampleMatrix gram = ComputeGram(
        inner_products, options.SimilarityFor(samples.num_features), samples, options.num_threads);
    CrossValidation validation = CrossValidate(gram, samples, folds, options);
    if (!search.points.empty() &&
        validation.num_correct > search.points[search.best].validation.num_correct) {
      search.best = search.points.size();
    }
    search.points.push_back({.options = options, .validation = std::move(validation)});
  }
  Report(base.progress, "combinations", combinations.size(), combinations.size());
  return search;
}

template <class T>
GridSearch SearchGridOfRows(const DesignMatrix<T>& X,
                            std::span<const std::uint32_t> classes,
                            std::span<const std::uint32_t> folds,
                            const Grid& grid,
                            const Options& base) {
  base.Validate();
  const Samples samples =
      PrepareSamples(X, classes, base.standardize ? FitNormaliser(X) : Normaliser{});
  return SearchGrid(
      ComputeInnerProducts(samples, base.num_threads, base.progress), samples, folds, grid, base);
}

template GridSearch SearchGridOfRows(const DesignMatrix<float>&,
                                     std::span<const std::uint32_t>,
                                     std::span<const std::uint32_t>,
                                     const Grid&,
                                     const Options&);
template GridSearch SearchGridOfRows(const DesignMatrix<double>&,
                                     std::span<const std::uint32_t>,
                                     std::span<const std::uint32_t>,
                                     const Grid&,
                                     const Options&);

}  // namespace handcraft::svm
