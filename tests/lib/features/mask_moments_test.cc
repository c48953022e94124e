// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/mask_moments.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "lib/features/mask_pixels.h"

namespace handcraft::features {
namespace {

struct Mask {
  int width;
  int height;
  std::vector<std::uint8_t> bytes;

  Mask(int w, int h) : width(w), height(h), bytes(static_cast<std::size_t>(w * h)) {}
  std::uint8_t& At(int u, int v) { return bytes[static_cast<std::size_t>(v * width + u)]; }
  [[nodiscard]] PixelMask View() const { return {bytes.data(), width}; }
  [[nodiscard]] bool Moments(HalvesMoments& moments) const {
    return MomentsOfHalves(View(), width, height, moments);
  }
};

Mask SomeMask(std::uint64_t seed) {
  Mask mask(37, 23);
  Rng rng(seed);
  for (std::uint8_t& byte : mask.bytes) byte = rng.UniformInt(3) == 0 ? 1 : 0;
  return mask;
}

// Pixel by pixel as Eq. 4.4 says.
HalvesMoments ByDefinition(const Mask& mask) {
  double area = 0.0;
  double sum_u = 0.0;
  for (std::size_t i = 0; i < mask.bytes.size(); ++i) {
    if (mask.bytes[i] == 0) continue;
    area += 1.0;
    sum_u += static_cast<double>(i % static_cast<std::size_t>(mask.width));
  }
  HalvesMoments moments{};
  for (std::size_t half = 0; half < 2; ++half) {
    std::vector<std::array<double, 2>> pixels;
    std::array<double, 2> mean{};
    for (int v = 0; v < mask.height; ++v) {
      for (int u = 0; u < mask.width; ++u) {
        const bool is_left = u < sum_u / area;
        if (mask.bytes[static_cast<std::size_t>(v * mask.width + u)] == 0) continue;
        if (is_left != (half == 0)) continue;
        pixels.push_back({double(u), double(v)});
        mean[0] += u;
        mean[1] += v;
      }
    }
    const auto count = static_cast<double>(pixels.size());
    moments[8 * half] = count;
    const int powers[7][2] = {{1, 1}, {2, 0}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};
    for (std::size_t k = 0; k < 7; ++k) {
      double mu = 0.0;
      for (const auto& p : pixels) {
        mu += std::pow(p[0] - mean[0] / count, powers[k][0]) *
              std::pow(p[1] - mean[1] / count, powers[k][1]);
      }
      moments[8 * half + 1 + k] = mu / std::pow(count, 1.0 + 0.5 * (powers[k][0] + powers[k][1]));
    }
  }
  return moments;
}

// Left of the centroid's column (2) two pixels one above the other, right of it a row of three.
TEST(MomentsOfHalves, OfAHandCase) {
  Mask mask(8, 4);
  mask.At(0, 1) = mask.At(0, 2) = 255;
  mask.At(2, 1) = mask.At(3, 1) = mask.At(4, 1) = 7;
  HalvesMoments moments;
  ASSERT_TRUE(mask.Moments(moments));
  EXPECT_EQ(moments[0], 2.0);
  EXPECT_EQ(moments[2], 0.0);        // η20
  EXPECT_EQ(moments[3], 0.5 / 4.0);  // η02: (½)² + (½)² over 2²
  EXPECT_EQ(moments[8], 3.0);
  EXPECT_NEAR(moments[10], 2.0 / 9.0, 1e-15);  // η20: 1 + 0 + 1 over 3²
  EXPECT_EQ(moments[11], 0.0);
  for (const std::size_t odd : {1, 4, 5, 6, 7, 9, 12, 13, 14, 15}) {
    EXPECT_NEAR(moments[odd], 0.0, 1e-15) << odd;
  }
}

TEST(MomentsOfHalves, AreThoseOfTheDefinition) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Mask mask = SomeMask(seed);
    HalvesMoments moments;
    ASSERT_TRUE(mask.Moments(moments));
    const HalvesMoments expected = ByDefinition(mask);
    for (std::size_t i = 0; i < kNumMoments; ++i) EXPECT_NEAR(moments[i], expected[i], 1e-11) << i;
  }
}

TEST(MomentsOfHalves, StayWhenThePictureMoves) {
  const Mask mask = SomeMask(3);
  Mask moved(100, 60);
  for (int v = 0; v < mask.height; ++v) {
    for (int u = 0; u < mask.width; ++u) {
      moved.At(u + 41, v + 30) = mask.bytes[static_cast<std::size_t>(v * mask.width + u)];
    }
  }
  HalvesMoments here;
  HalvesMoments there;
  ASSERT_TRUE(mask.Moments(here));
  ASSERT_TRUE(moved.Moments(there));
  for (std::size_t i = 0; i < kNumMoments; ++i) EXPECT_NEAR(here[i], there[i], 1e-12) << i;
}

// Each pixel as 6 × 6: areas grow 36-fold, the others stay but for what a square pixel adds.
TEST(MomentsOfHalves, StayWhenThePictureGrows) {
  Mask mask(60, 40);
  for (int v = 5; v < 35; ++v) {
    for (int u = 8; u < 8 + v; ++u) mask.At(u, v) = 1;
  }
  Mask large(360, 240);
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 360; ++u) large.At(u, v) = mask.At(u / 6, v / 6);
  }
  HalvesMoments small_moments;
  HalvesMoments large_moments;
  ASSERT_TRUE(mask.Moments(small_moments));
  ASSERT_TRUE(large.Moments(large_moments));
  for (const std::size_t half : {0, 8}) {
    // The centroid's column may cut a pixel of the small picture.
    EXPECT_NEAR(large_moments[half] / 36.0 / small_moments[half], 1.0, 0.05);
    for (std::size_t i = 1; i < 8; ++i) {
      EXPECT_NEAR(large_moments[half + i], small_moments[half + i], 0.01) << half + i;
    }
  }
}

TEST(MomentsOfHalves, SwapInAMirror) {
  const Mask mask = SomeMask(5);
  Mask mirrored(mask.width, mask.height);
  for (int v = 0; v < mask.height; ++v) {
    for (int u = 0; u < mask.width; ++u) {
      mirrored.At(mask.width - 1 - u, v) = mask.bytes[static_cast<std::size_t>(v * mask.width + u)];
    }
  }
  HalvesMoments here;
  HalvesMoments there;
  ASSERT_TRUE(mask.Moments(here));
  ASSERT_TRUE(mirrored.Moments(there));
  const double signs[] = {1, -1, 1, 1, -1, 1, -1, 1};  // odd powers of u change sign
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(there[8 + i], signs[i] * here[i], 1e-12) << i;
}

TEST(MomentsOfHalves, NeedTwoHalves) {
  HalvesMoments moments;
  Mask mask(9, 9);
  EXPECT_FALSE(mask.Moments(moments));
  for (int v = 0; v < 9; ++v) mask.At(4, v) = 1;
  EXPECT_FALSE(mask.Moments(moments));
  mask.At(5, 0) = 1;
  EXPECT_TRUE(mask.Moments(moments));
}

TEST(ForEachMaskRun, FindsEveryRun) {
  for (const int width : {1, 7, 8, 9, 40}) {
    Mask mask(width, 6);
    Rng rng(static_cast<std::uint64_t>(width));
    for (std::uint8_t& byte : mask.bytes) byte = rng.UniformInt(4) == 0 ? 9 : 0;
    Mask seen(width, 6);
    ForEachMaskRun(mask.View(), width, 6, [&](int v, int first_u, int last_u) {
      EXPECT_LT(first_u, last_u);
      EXPECT_TRUE(last_u == width || mask.At(last_u, v) == 0);
      for (int u = first_u; u < last_u; ++u) seen.At(u, v) = 9;
    });
    EXPECT_EQ(seen.bytes, mask.bytes) << width;
  }
}

}  // namespace
}  // namespace handcraft::features
