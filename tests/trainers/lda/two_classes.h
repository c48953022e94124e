// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "lib/core/design_matrix.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"

namespace handcraft::lda {

/// A design matrix that owns its numbers, with labels.
struct TwoClasses {
  std::size_t num_features = 0;
  std::vector<double> values = {};
  std::vector<std::uint8_t> labels = {};

  [[nodiscard]] DesignMatrix<double> X() const {
    return {.data = values.data(),
            .num_samples = labels.size(),
            .num_features = num_features,
            .stride = num_features};
  }
};

/// Normal classes with one covariance, entries min(i, j) + 1, and means `apart` from each other in
/// every feature; a share of a third is positive.
inline TwoClasses DrawTwoClasses(std::size_t num_samples,
                                 std::size_t num_features,
                                 double apart,
                                 std::uint64_t seed) {
  Rng rng(seed);
  TwoClasses data{.num_features = num_features};
  for (std::size_t i = 0; i < num_samples; ++i) {
    const auto label = static_cast<std::uint8_t>(i % 3 == 0);
    double walk = 0.0;
    for (std::size_t j = 0; j < num_features; ++j) {
      walk += rng.Normal();
      data.values.push_back(walk + apart * label);
    }
    data.labels.push_back(label);
  }
  return data;
}

/// A table of tests/data/trainers: features, then the label.
inline TwoClasses ReadTwoClasses(const std::string& name) {
  std::istringstream lines(ReadTextFile(std::string(HANDCRAFT_SOURCE_DIR) +
                                        "/tests/data/trainers/logistic_" + name + ".csv"));
  TwoClasses data;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::vector<double> row;
    for (std::string word; std::getline(words, word, ',');) row.push_back(std::stod(word));
    data.labels.push_back(static_cast<std::uint8_t>(row.back()));
    row.pop_back();
    data.num_features = row.size();
    data.values.insert(data.values.end(), row.begin(), row.end());
  }
  return data;
}

}  // namespace handcraft::lda
