// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/row_sampler.h"

#include <algorithm>
#include <cmath>

#include "lib/core/check.h"

namespace handcraft::logistic {

RowSample DrawRows(std::span<const double> squared_norms,
                   std::span<const double> scores,
                   std::size_t num_wanted,
                   Rng& rng) {
  HC_CHECK(squared_norms.size() == scores.size(), squared_norms.size(), scores.size());
  const std::size_t num_rows = scores.size();
  std::vector<double> probability(num_rows);
  double sum = 0.0;
  for (std::size_t i = 0; i < num_rows; ++i) {
    const double e = std::exp(-std::abs(scores[i]));
    probability[i] = squared_norms[i] * e / ((1.0 + e) * (1.0 + e));
    sum += probability[i];
  }
  const double per_norm = sum > 0.0 ? 1.0 / sum : 0.0;
  const double per_row = 1.0 / static_cast<double>(num_rows);
  const double wanted = 0.5 * static_cast<double>(num_wanted);
  RowSample sample;
  for (std::size_t i = 0; i < num_rows; ++i) {
    const double q = std::min(1.0, wanted * (per_row + probability[i] * per_norm));
    if (rng.Uniform() >= q) continue;
    sample.rows.push_back(i);
    sample.weights.push_back(1.0 / q);
  }
  return sample;
}

}  // namespace handcraft::logistic
