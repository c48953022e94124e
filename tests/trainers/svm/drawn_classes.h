// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/core/rng.h"

namespace handcraft::svm {

/// Samples of classes that overlap: normal clouds about centres drawn in −1 … 1.
template <class T>
struct DrawnClasses {
  std::vector<T> values;
  std::vector<std::uint32_t> classes;
  std::size_t num_features = 0;

  [[nodiscard]] DesignMatrix<T> Matrix() const noexcept {
    return {.data = values.data(),
            .num_samples = classes.size(),
            .num_features = num_features,
            .stride = num_features};
  }
};

struct DrawnSize {
  std::size_t num_classes = 3;
  std::size_t samples_per_class = 12;
  std::size_t num_features = 5;
  double spread = 0.6;
};

/// Classes take turns, so that their samples lie apart in the table.
template <class T>
DrawnClasses<T> DrawClasses(const DrawnSize& size, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<double> centres(size.num_classes * size.num_features);
  for (double& centre : centres) centre = 2.0 * rng.Uniform() - 1.0;
  DrawnClasses<T> drawn{.values = {}, .classes = {}, .num_features = size.num_features};
  for (std::size_t i = 0; i < size.num_classes * size.samples_per_class; ++i) {
    const std::size_t c = i % size.num_classes;
    drawn.classes.push_back(static_cast<std::uint32_t>(c));
    for (std::size_t j = 0; j < size.num_features; ++j) {
      drawn.values.push_back(
          static_cast<T>(centres[c * size.num_features + j] + size.spread * rng.Normal()));
    }
  }
  return drawn;
}

}  // namespace handcraft::svm
