// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/region_pass.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/feature_oracle.h"

namespace handcraft::features::internal {
namespace {

using features::testing::MakePicture;
using features::testing::OracleFeatures;
using features::testing::RandomWeights;

// One filter, window 3, all in double from the definitions: the pass against the oracle.
TEST(ScoreRegion, FormsTheSumOfTheOraclesFeatures) {
  constexpr int kWidth = 70;
  constexpr int kHeight = 12;
  const FeatureSpec spec = ParseFeatureSpec("filters=edge_30+laplacian,window=3");
  const auto picture = MakePicture(kWidth, kHeight, PixelFormat::kGray8, 1);
  const PixelKernels& kernels = KernelsFor(SupportedInstructionSets().back());
  std::vector<float> planes_memory(ChannelPlanes::NumFloats(kWidth, kHeight, 1));
  ChannelPlanes planes(kWidth, kHeight, 1, planes_memory.data());
  planes.Convert(picture.raw, kernels);
  const std::vector<float> weights = RandomWeights(18, 1.0, 2);  // [row][column][filter]
  std::vector<float> packed;
  packed.reserve(weights.size());
  for (std::size_t filter = 0; filter < 2; ++filter) {
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t row = 0; row < 3; ++row) {
        packed.push_back(weights[2 * (3 * row + column) + filter]);
      }
    }
  }
  const FilterPlan plan(spec);
  const ScoringLevel level{planes, plan, kernels, packed.data(), 3, 0.5F, {}, false};

  std::vector<std::uint8_t> wanted(kWidth * kHeight);
  const std::vector<PixelPosition> pixels = {{0, 0}, {69, 0}, {30, 5}, {33, 5}, {1, 11}};
  for (const auto& pixel : pixels) wanted[static_cast<std::size_t>(pixel.v * kWidth + pixel.u)] = 1;
  const PixelMask mask{wanted.data(), kWidth};
  std::vector<float> sums(RegionSums::NumFloats(kWidth, 3));
  const auto buffers = std::make_unique<StripBuffers>();
  std::vector<float> map(kWidth * kHeight, -1.0F);
  std::vector<float> values(pixels.size());
  const RegionBox box = BoxOf(mask, kWidth, kHeight);
  ScoreRegion(level, mask, box, {sums.data()}, *buffers, {.map = map.data(), .stride = kWidth});
  ScoreRegion(
      level, mask, box, {sums.data()}, *buffers, {.pixels = pixels, .values = values.data()});

  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::vector<double> x = OracleFeatures(picture.raw, spec, pixels[i].u, pixels[i].v);
    double z = 0.5;
    for (std::size_t j = 0; j < x.size(); ++j) z += x[j] * static_cast<double>(weights[j]);
    EXPECT_NEAR(values[i], z, 1e-5) << i;
    EXPECT_EQ(map[static_cast<std::size_t>(pixels[i].v * kWidth + pixels[i].u)], values[i]);
  }
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (wanted[i] == 0) {
      EXPECT_EQ(map[i], 0.0F) << i;
    }
  }
}

TEST(ScoreRegion, ClearsTheMapOfAnEmptyRegion) {
  std::vector<float> planes_memory(ChannelPlanes::NumFloats(4, 3, 1));
  const ChannelPlanes planes(4, 3, 1, planes_memory.data());
  const FilterPlan plan(ParseFeatureSpec("edges54"));
  const PixelKernels& kernels = KernelsFor(SupportedInstructionSets().back());
  const std::vector<float> weights(54);
  const std::vector<std::uint8_t> wanted(12);
  std::vector<float> sums(RegionSums::NumFloats(4, 3));
  const auto buffers = std::make_unique<StripBuffers>();
  std::vector<float> map(12, -1.0F);
  ScoreRegion({planes, plan, kernels, weights.data(), 3, 0.0F, {}, true},
              {wanted.data(), 4},
              {},
              {sums.data()},
              *buffers,
              {.map = map.data(), .stride = 4});
  EXPECT_EQ(map, std::vector<float>(12, 0.0F));
}

}  // namespace
}  // namespace handcraft::features::internal
