// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include "lib/core/rng.h"
#include "lib/features/colour.h"
#include "lib/features/feature_spec.h"

namespace handcraft::features::testing {

/// A picture with its own pixels.
struct Picture {
  std::vector<std::uint8_t> bytes;
  RawImage raw;
};

/// Blobs, ramps and noise: smooth and busy regions side by side. `gap` bytes lie between rows.
[[nodiscard]] Picture MakePicture(
    int width, int height, PixelFormat format, std::uint64_t seed, int gap = 0);

/// The feature vector of one pixel straight from the definitions in filter_bank.h and
/// feature_spec.h: double precision, every kernel tap in turn, nothing shared.
[[nodiscard]] std::vector<double> OracleFeatures(const RawImage& image,
                                                 const FeatureSpec& spec,
                                                 int u,
                                                 int v);

/// Numbers of a normal distribution.
[[nodiscard]] std::vector<float> RandomWeights(int count, double scale, std::uint64_t seed);

}  // namespace handcraft::features::testing
