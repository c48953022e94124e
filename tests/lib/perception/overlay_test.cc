// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/overlay.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/support/expect_throws_message.h"

namespace handcraft::perception {
namespace {

std::vector<int> Pixel(const Image& image, int u, int v) {
  return {image.At(u, v, 0), image.At(u, v, 1), image.At(u, v, 2)};
}

TEST(DrawGraspPoints, BlendsWarmOverTheProbable) {
  const Image gray(3, 1, 1, 100);
  FloatImage probabilities(3, 1);
  probabilities.At(1, 0) = 0.5F;
  probabilities.At(2, 0) = 1.0F;
  const Image drawn = DrawGraspPoints(gray, probabilities, {});
  EXPECT_EQ(drawn.channels(), 3);
  EXPECT_EQ(Pixel(drawn, 0, 0), (std::vector{100, 100, 100}));
  EXPECT_EQ(Pixel(drawn, 1, 0), (std::vector{80, 100, 131}));  // 20 % of (0, 100, 255)
  EXPECT_EQ(Pixel(drawn, 2, 0), (std::vector{60, 60, 162}));   // 40 % of (0, 0, 255)
}

TEST(DrawGraspPoints, TakesProbabilitiesOutOfRangeAndNotANumber) {
  const Image picture(3, 1, 3, 100);
  FloatImage probabilities(3, 1);
  probabilities.At(0, 0) = -5.0F;
  probabilities.At(1, 0) = 7.0F;
  probabilities.At(2, 0) = std::numeric_limits<float>::quiet_NaN();
  const Image drawn = DrawGraspPoints(picture, probabilities, {});
  EXPECT_EQ(Pixel(drawn, 0, 0), (std::vector{100, 100, 100}));
  EXPECT_EQ(Pixel(drawn, 1, 0), (std::vector{60, 60, 162}));
  EXPECT_EQ(Pixel(drawn, 2, 0), (std::vector{100, 100, 100}));
}

TEST(DrawGraspPoints, LeavesThePictureWithoutMapAndPoints) {
  const Image picture(4, 3, 3, 9);
  EXPECT_EQ(DrawGraspPoints(picture, {}, {}).values(), picture.values());
  EXPECT_TRUE(DrawGraspPoints({}, {}, {}).empty());
}

TEST(DrawGraspPoints, MarksOnlyTheNeighbourhoodOfAPoint) {
  const Image picture(100, 100, 1, 50);
  const std::vector<MarkedPoint> points = {{30, 40, 0.9F}};
  const Image drawn = DrawGraspPoints(picture, {}, points);
  EXPECT_NE(Pixel(drawn, 25, 40), (std::vector{50, 50, 50})) << "the circle, radius 5";
  EXPECT_EQ(Pixel(drawn, 30, 40), (std::vector{50, 50, 50})) << "its middle stays visible";
  EXPECT_EQ(Pixel(drawn, 80, 80), (std::vector{50, 50, 50}));
}

TEST(DrawGraspPoints, DrawsAtCornersOutsideAndOnTinyPictures) {
  const std::vector<MarkedPoint> points = {{0, 0, 1.0F}, {99, 0, 1.0F}, {-500, 1 << 20, 1.0F}};
  EXPECT_EQ(DrawGraspPoints(Image(100, 20, 3), {}, points).width(), 100);
  EXPECT_EQ(DrawGraspPoints(Image(1, 1, 1), {}, points).width(), 1);
}

// Green pixels outside the circles, which reach 7 px from their centres.
int CountRankPixels(const Image& drawn, const std::vector<MarkedPoint>& points) {
  int bright = 0;
  for (int v = 0; v < drawn.height(); ++v) {
    for (int u = 0; u < drawn.width(); ++u) {
      const bool is_circle = std::any_of(points.begin(), points.end(), [&](const auto& point) {
        return std::hypot(u - point.u_px, v - point.v_px) <= 7.5;
      });
      if (!is_circle && drawn.At(u, v, 1) > 60) ++bright;
    }
  }
  return bright;
}

TEST(DrawGraspPoints, WritesTheRankInsideThePicture) {
  for (const MarkedPoint point :
       {MarkedPoint{99, 50}, MarkedPoint{0, 50}, MarkedPoint{50, 0}, MarkedPoint{99, 99}}) {
    const std::vector<MarkedPoint> points = {point};
    const Image drawn = DrawGraspPoints(Image(100, 100, 1, 0), {}, points);
    EXPECT_GT(CountRankPixels(drawn, points), 3) << point.u_px << ' ' << point.v_px;
  }
}

// Neighbours push a number aside; a point shut in by others has none.
TEST(DrawGraspPoints, WritesNoRankOverACircle) {
  std::vector<MarkedPoint> points = {{50, 50, 1.0F}};
  const Image alone = DrawGraspPoints(Image(100, 100, 1, 0), {}, points);
  for (int v = 0; v <= 100; v += 10) {
    for (int u = 0; u <= 100; u += 10) points.push_back({u, v, 0.5F});
  }
  const Image crowded = DrawGraspPoints(Image(100, 100, 1, 0), {}, points);
  EXPECT_GT(CountRankPixels(alone, {points.front()}), 3);
  EXPECT_EQ(CountRankPixels(crowded, points), 0);
}

TEST(DrawGraspPoints, RefusesAMapOfAnotherSize) {
  EXPECT_THROWS_MESSAGE(DrawGraspPoints(Image(4, 3), FloatImage(3, 4), {}),
                        std::logic_error,
                        ::testing::HasSubstr("3, 4, 4, 3"));
}

TEST(DrawLabelMask, ColoursGoodAndDontCare) {
  const Image gray(3, 1, 1, 100);
  Image mask(3, 1, 1, 0);
  mask.At(1, 0) = 128;
  mask.At(2, 0) = 255;
  const Image drawn = DrawLabelMask(gray, mask);
  EXPECT_EQ(Pixel(drawn, 0, 0), (std::vector{100, 100, 100}));
  EXPECT_EQ(Pixel(drawn, 1, 0), (std::vector{147, 94, 70}));
  EXPECT_EQ(Pixel(drawn, 2, 0), (std::vector{40, 178, 40}));
}

TEST(DrawLabelMask, OutlinesWhatIsGoodInWhiteAndBlack) {
  Image mask(256, 3, 1, 0);
  for (int u = 10; u < 20; ++u) {
    for (int v = 0; v < 3; ++v) mask.At(u, v) = 255;
  }
  mask.At(21, 1) = 128;  // the line goes over it
  mask.At(40, 1) = 128;
  const Image drawn = DrawLabelMask(Image(256, 3, 1, 100), mask);
  const std::vector<int> bad = {100, 100, 100};
  EXPECT_EQ(Pixel(drawn, 7, 1), bad);
  EXPECT_EQ(Pixel(drawn, 8, 1), (std::vector{0, 0, 0}));
  EXPECT_EQ(Pixel(drawn, 9, 1), (std::vector{255, 255, 255}));
  EXPECT_EQ(Pixel(drawn, 10, 1), (std::vector{40, 178, 40}));
  EXPECT_EQ(Pixel(drawn, 19, 1), (std::vector{40, 178, 40}));
  EXPECT_EQ(Pixel(drawn, 20, 1), (std::vector{255, 255, 255}));
  EXPECT_EQ(Pixel(drawn, 21, 1), (std::vector{0, 0, 0}));
  EXPECT_EQ(Pixel(drawn, 22, 1), bad);
  EXPECT_EQ(Pixel(drawn, 40, 1), (std::vector{147, 94, 70})) << "what is don't care has none";
}

TEST(DrawLabelMask, RefusesAMaskOfAnotherSize) {
  EXPECT_THROWS_MESSAGE(
      DrawLabelMask(Image(4, 3), Image(3, 3)), std::logic_error, ::testing::HasSubstr("3, 3, 4"));
}

TEST(DrawRegion, TintsTheRegionAlone) {
  Image mask(2, 1);
  mask.At(1, 0) = 255;
  const Image drawn = DrawRegion(Image(2, 1, 1, 100), mask);
  EXPECT_EQ(Pixel(drawn, 0, 0), (std::vector{100, 100, 100}));
  EXPECT_EQ(Pixel(drawn, 1, 0), (std::vector{178, 90, 50}));
  EXPECT_THROWS_MESSAGE(
      DrawRegion(Image(4, 3), Image(3, 3)), std::logic_error, ::testing::HasSubstr("3, 3, 4"));
}

}  // namespace
}  // namespace handcraft::perception
