// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "lib/core/rng.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::logistic {

/// A design matrix that owns its numbers, with labels.
template <class T>
struct Problem {
  std::size_t num_features = 0;
  std::vector<T> values = {};
  std::vector<std::uint8_t> labels = {};

  [[nodiscard]] DesignMatrix<T> X() const {
    return {.data = values.data(),
            .num_samples = labels.size(),
            .num_features = num_features,
            .stride = num_features};
  }
  [[nodiscard]] T& At(std::size_t i, std::size_t j) { return values[i * num_features + j]; }
};

/// Normal features; labels drawn from a logistic model with weights 0.5, −0.5, 0.5 … / √p and
/// intercept 0.2. With tail > 0 a feature is x · exp(tail · normal): heavy tails, far leverage.
template <class T>
Problem<T> DrawProblem(std::size_t num_samples,
                       std::size_t num_features,
                       std::uint64_t seed,
                       double tail = 0.0) {
  Rng rng(seed);
  Problem<T> problem{.num_features = num_features};
  for (std::size_t i = 0; i < num_samples; ++i) {
    double z = 0.2;
    for (std::size_t j = 0; j < num_features; ++j) {
      const double x = rng.Normal() * std::exp(tail * rng.Normal());
      const auto value = static_cast<T>(static_cast<float>(x));  // the same number in both types
      problem.values.push_back(value);
      z += (j % 2 == 0 ? 1.0 : -1.0) * static_cast<double>(value) /
           std::sqrt(static_cast<double>(num_features));
    }
    problem.labels.push_back(rng.Uniform() < 1.0 / (1.0 + std::exp(-z)) ? 1 : 0);
  }
  return problem;
}

/// A problem written out: rows of features, then the label last.
inline Problem<double> ProblemOf(const std::vector<std::vector<double>>& rows) {
  Problem<double> problem{.num_features = rows.front().size() - 1};
  for (const std::vector<double>& row : rows) {
    problem.values.insert(problem.values.end(), row.begin(), row.end() - 1);
    problem.labels.push_back(static_cast<std::uint8_t>(row.back()));
  }
  return problem;
}

}  // namespace handcraft::logistic
