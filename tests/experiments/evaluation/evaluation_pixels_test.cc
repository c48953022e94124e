// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/evaluation_pixels.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::experiments {
namespace {

std::size_t CountLabel(const std::vector<EvaluationPixel>& pixels, std::uint8_t label) {
  return static_cast<std::size_t>(std::count_if(
      pixels.begin(), pixels.end(), [&](const EvaluationPixel& p) { return p.label == label; }));
}

// Good, bad and don't-care pixels in equal shares.
Image RandomMask(std::uint64_t seed, int width, int height) {
  constexpr std::array<std::uint8_t, 3> kValues = {0, 128, 255};
  Rng rng(seed);
  Image mask(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) mask.At(u, v) = kValues[rng.UniformInt(3)];
  }
  return mask;
}

TEST(DrawEvaluationPixels, TakesAsManyOfEachAsTheScarcerHas) {
  Image mask(4, 2, 1, 0);
  mask.At(1, 0) = 255;
  mask.At(3, 1) = 255;
  mask.At(0, 0) = 128;
  const auto pixels = DrawEvaluationPixels(mask, 100, 1, "a.png");
  ASSERT_EQ(pixels.size(), 4U);
  EXPECT_EQ(pixels[0].index, 1U);
  EXPECT_EQ(pixels[1].index, 7U);
  EXPECT_EQ(CountLabel(pixels, 1), 2U);
  for (const EvaluationPixel& pixel : pixels) EXPECT_NE(pixel.index, 0U);
}

TEST(DrawEvaluationPixels, DrawsLabelledPixelsOnceHalfGoodHalfBad) {
  const Image mask = RandomMask(1, 40, 30);
  for (const std::size_t count : {2U, 100U, 101U, 500U}) {
    const auto pixels = DrawEvaluationPixels(mask, count, 3, "a.png");
    EXPECT_EQ(CountLabel(pixels, 1), count / 2);
    EXPECT_EQ(CountLabel(pixels, 0), count / 2);
    std::set<std::size_t> indices;
    for (const EvaluationPixel& pixel : pixels) {
      indices.insert(pixel.index);
      EXPECT_EQ(mask.values()[pixel.index], pixel.label == 1 ? 255 : 0);
    }
    EXPECT_EQ(indices.size(), pixels.size());
  }
}

TEST(DrawEvaluationPixels, DependsOnSeedAndName) {
  const Image mask = RandomMask(2, 40, 30);
  const auto indices = [&](std::uint64_t seed, const char* name) {
    std::vector<std::size_t> result;
    for (const EvaluationPixel& pixel : DrawEvaluationPixels(mask, 50, seed, name)) {
      result.push_back(pixel.index);
    }
    return result;
  };
  EXPECT_EQ(indices(1, "a.png"), indices(1, "a.png"));
  EXPECT_NE(indices(1, "a.png"), indices(2, "a.png"));
  EXPECT_NE(indices(1, "a.png"), indices(1, "b.png"));
}

TEST(DrawEvaluationPixels, OneKindAloneEmptyAndDontCareOnly) {
  const auto good_only = DrawEvaluationPixels(Image(5, 5, 1, 255), 20, 1, "a.png");
  EXPECT_EQ(good_only.size(), 10U);
  EXPECT_EQ(CountLabel(good_only, 1), 10U);
  const auto bad_only = DrawEvaluationPixels(Image(2, 2, 1, 0), 20, 1, "a.png");
  EXPECT_EQ(bad_only.size(), 4U);
  EXPECT_EQ(CountLabel(bad_only, 0), 4U);
  EXPECT_TRUE(DrawEvaluationPixels(Image(5, 5, 1, 128), 20, 1, "a.png").empty());
  EXPECT_TRUE(DrawEvaluationPixels(Image(), 20, 1, "a.png").empty());
}

}  // namespace
}  // namespace handcraft::experiments
