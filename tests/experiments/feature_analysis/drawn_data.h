// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstdint>

#include "experiments/feature_analysis/held_out_fit.h"
#include "lib/core/rng.h"

namespace handcraft::experiments {

/// Four features: 0 and 1 tell the label (0 twice as well), 2 copies 0 with noise, 3 is noise of
/// huge variance. Five held-out groups.
inline HeldOutData DrawHeldOut(std::size_t num_samples, std::uint64_t seed) {
  Rng rng(seed);
  HeldOutData data{.num_features = 4, .num_held_out_groups = 5};
  for (std::size_t i = 0; i < num_samples; ++i) {
    const double first = rng.Normal();
    const double second = rng.Normal();
    const double z = 2.0 * first + second;
    const std::uint8_t label = rng.Uniform() < 1.0 / (1.0 + std::exp(-z)) ? 1 : 0;
    const bool held_out = i % 3 == 0;
    auto& features = held_out ? data.held_out_features : data.features;
    features.insert(features.end(),
                    {static_cast<float>(first),
                     static_cast<float>(second),
                     static_cast<float>(first + 0.5 * rng.Normal()),
                     static_cast<float>(100.0 * rng.Normal())});
    (held_out ? data.held_out_labels : data.labels).push_back(label);
    if (held_out) data.held_out_groups.push_back(i % 5);
  }
  return data;
}

}  // namespace handcraft::experiments
