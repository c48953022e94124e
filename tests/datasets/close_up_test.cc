// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/close_up.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/datasets/small_image_set.h"

namespace handcraft::datasets {
namespace {

using perception::PixelBox;

constexpr std::uint8_t kHere = 255;

void ExpectBox(const PixelBox& found, const PixelBox& expected) {
  EXPECT_EQ(found.u_px, expected.u_px);
  EXPECT_EQ(found.v_px, expected.v_px);
  EXPECT_EQ(found.width, expected.width);
  EXPECT_EQ(found.height, expected.height);
}

TEST(FindBox, IsTheSmallestThatHoldsThemAll) {
  Image mask(20, 10);
  EXPECT_FALSE(FindBox(mask, kHere));
  mask.At(19, 9) = kHere;
  ExpectBox(FindBox(mask, kHere).value(), {19, 9, 1, 1});
  mask.At(3, 5) = kHere;
  mask.At(0, 0) = 128;
  ExpectBox(FindBox(mask, kHere).value(), {3, 5, 17, 5});
  ExpectBox(FindBox(mask, 128).value(), {0, 0, 1, 1});
  EXPECT_FALSE(FindBox(Image(), kHere));
}

TEST(CloseUpOf, HasAMarginOfAQuarterAndIsFourByThree) {
  // 40 wide, so 10 around it: 60 × 28, heightened to 60 × 45.
  ExpectBox(CloseUpOf({80, 46, 40, 8}, 200, 100), {70, 46 - 18, 60, 45});
  // 40 high: 28 × 60, widened to 80 × 60.
  ExpectBox(CloseUpOf({80, 30, 8, 40}, 200, 100), {80 - 36, 20, 80, 60});
}

TEST(CloseUpOf, HasEightPixelsAroundWhatIsSmall) {
  ExpectBox(CloseUpOf({90, 50, 1, 1}, 200, 100), {80, 42, 22, 17});
}

TEST(CloseUpOf, StaysWithinThePicture) {
  ExpectBox(CloseUpOf({196, 0, 4, 4}, 200, 100), {174, 0, 26, 20});  // moved, not cut
  ExpectBox(CloseUpOf({0, 10, 200, 80}, 200, 100), {0, 0, 200, 100});
  Rng rng = Rng::Stream(1, "close-ups");
  const auto draw = [&](int count) {
    return static_cast<int>(rng.UniformInt(static_cast<std::uint64_t>(count)));
  };
  for (int i = 0; i < 1000; ++i) {
    const int width = 1 + draw(90);
    const int height = 1 + draw(90);
    const int u = draw(width);
    const int v = draw(height);
    const PixelBox box{u, v, 1 + draw(width - u), 1 + draw(height - v)};
    const PixelBox found = CloseUpOf(box, width, height);
    EXPECT_GE(found.u_px, 0);
    EXPECT_LE(found.u_px, box.u_px);
    EXPECT_GE(found.u_px + found.width, box.u_px + box.width);
    EXPECT_LE(found.u_px + found.width, width);
    EXPECT_GE(found.v_px, 0);
    EXPECT_LE(found.v_px, box.v_px);
    EXPECT_GE(found.v_px + found.height, box.v_px + box.height);
    EXPECT_LE(found.v_px + found.height, height);
  }
}

TEST(CutOut, TakesThePixelsOfTheBox) {
  const Image picture = testing::NoiseImage(9, 7, 3, 1);
  const Image part = CutOut(picture, {2, 1, 4, 5});
  ASSERT_EQ(part.width(), 4);
  ASSERT_EQ(part.height(), 5);
  for (int v = 0; v < 5; ++v) {
    EXPECT_TRUE(std::equal(part.Row(v), part.Row(v) + 12, picture.Row(1 + v) + 6)) << v;
  }
  EXPECT_EQ(CutOut(picture, {0, 0, 9, 7}).values(), picture.values());
  EXPECT_THROW(static_cast<void>(CutOut(picture, {6, 0, 4, 7})), std::logic_error);
  EXPECT_THROW(static_cast<void>(CutOut(picture, {0, -1, 4, 7})), std::logic_error);
}

}  // namespace
}  // namespace handcraft::datasets
