// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/stereo_matching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

using ::testing::HasSubstr;

Image NoiseImage(int width, int height, int channels, std::uint64_t seed) {
  Rng rng = Rng::Stream(seed, "noise");
  Image image(width, height, channels);
  for (int v = 0; v < height; ++v) {
    for (int i = 0; i < width * channels; ++i) {
      image.Row(v)[i] = static_cast<std::uint8_t>(rng.UniformInt(256));
    }
  }
  return image;
}

// Noise, and the same moved to the left by a whole number of pixels.
TEST(MatchPair, FindsTheShiftOfAPicture) {
  constexpr int kShiftPx = 11;
  const Image left = NoiseImage(120, 40, 3, 1);
  Image right = NoiseImage(120, 40, 3, 2);
  for (int v = 0; v < 40; ++v) std::copy_n(left.Row(v) + 3 * kShiftPx, 3 * 109, right.Row(v));
  for (const StereoMatcher matcher : {StereoMatcher::kSemiGlobal, StereoMatcher::kBlock}) {
    const FloatImage disparity_px = MatchPair(left, right, matcher, 16);
    int num_right = 0;
    for (int v = 8; v < 32; ++v) {
      EXPECT_TRUE(std::isnan(disparity_px.At(15, v)));
      for (int u = 32; u < 100; ++u)
        num_right += std::abs(disparity_px.At(u, v) - 11.0F) < 0.2F ? 1 : 0;
    }
    EXPECT_EQ(num_right, 24 * 68) << "but for parts of a pixel";
  }
}

TEST(MatchPair, TakesGrayPictures) {
  const Image left = NoiseImage(60, 30, 1, 1);
  Image right = NoiseImage(60, 30, 1, 2);
  for (int v = 0; v < 30; ++v) std::copy_n(left.Row(v) + 5, 55, right.Row(v));
  EXPECT_NEAR(MatchPair(left, right, StereoMatcher::kSemiGlobal, 16).At(40, 15), 5.0F, 0.2F);
}

TEST(MatchPair, RefusesPicturesThatAreNoPair) {
  EXPECT_THROWS_MESSAGE(MatchPair(Image(60, 30), Image(61, 30), StereoMatcher::kBlock, 16),
                        std::logic_error,
                        HasSubstr("60, 61"));
  EXPECT_THROWS_MESSAGE(MatchPair(Image(60, 30), Image(60, 30), StereoMatcher::kBlock, 15),
                        std::logic_error,
                        HasSubstr("15"));
}

TEST(NumDisparities, CoversTheNearestPoint) {
  EXPECT_EQ(NumDisparities(525.0F, 0.12F, 0.4F), 160) << "525 · 0.12 / 0.4 = 157.5";
  EXPECT_EQ(NumDisparities(100.0F, 0.05F, 1.0F), 16);
}

TEST(DepthOfDisparity, DividesAndLeavesOut) {
  FloatImage disparity_px(5, 1);
  disparity_px.At(0, 0) = 63.0F;
  disparity_px.At(1, 0) = std::numeric_limits<float>::quiet_NaN();
  disparity_px.At(2, 0) = 0.0F;
  disparity_px.At(3, 0) = -4.0F;
  disparity_px.At(4, 0) = 21.0F;
  const FloatImage depth_m = DepthOfDisparity(disparity_px, 525.0F, 0.12F, 2.0F);
  EXPECT_FLOAT_EQ(depth_m.At(0, 0), 1.0F);
  for (const int u : {1, 2, 3, 4}) EXPECT_EQ(depth_m.At(u, 0), 0.0F) << u;
}

}  // namespace
}  // namespace handcraft::perception
