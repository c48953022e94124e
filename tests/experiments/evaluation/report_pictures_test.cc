// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/report_pictures.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

cv::Mat Decode(const std::vector<std::uint8_t>& bytes) {
  return cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
}

TEST(EncodeJpeg, ShrinksWidePicturesAndLeavesSmallOnes) {
  const cv::Mat shrunk = Decode(EncodeJpeg(Image(640, 480, 3, 200), 320));
  EXPECT_EQ(shrunk.cols, 320);
  EXPECT_EQ(shrunk.rows, 240);
  EXPECT_NEAR(shrunk.at<cv::Vec3b>(100, 100)[1], 200, 2);
  const cv::Mat small = Decode(EncodeJpeg(Image(40, 7, 3, 10), 320));
  EXPECT_EQ(small.cols, 40);
  EXPECT_EQ(small.rows, 7);
  EXPECT_EQ(Decode(EncodeJpeg(Image(10000, 3, 3), 100)).rows, 1);
}

TEST(EncodeJpeg, RefusesGrayAndEmptyPictures) {
  EXPECT_THROWS_MESSAGE(EncodeJpeg(Image(4, 4), 10), std::logic_error, HasSubstr("4, 4, 1"));
  EXPECT_THROWS_MESSAGE(EncodeJpeg(Image(0, 0, 3), 10), std::logic_error, HasSubstr("0, 0, 3"));
}

bool HasColourNear(const Image& image, int blue, int green, int red) {
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      if (std::abs(image.At(u, v, 0) - blue) < 12 && std::abs(image.At(u, v, 1) - green) < 12 &&
          std::abs(image.At(u, v, 2) - red) < 12) {
        return true;
      }
    }
  }
  return false;
}

TEST(DrawCloseUp, RingsPixelsByTheGroundTheyLieOn) {
  const Image gray(600, 480, 1, 128);
  const std::vector<BestPixel> good = {{300, 240, 0.95F, 255}};
  const Image close_up = DrawCloseUp(gray, good);
  EXPECT_EQ(close_up.channels(), 3);
  EXPECT_EQ(close_up.width(), 280);
  EXPECT_EQ(close_up.height(), 224);  // 100 × 80 px enlarged 2.8-fold
  EXPECT_TRUE(HasColourNear(close_up, 70, 230, 60));
  EXPECT_FALSE(HasColourNear(close_up, 50, 60, 240));
  const std::vector<BestPixel> bad_beside = {{300, 240, 0.95F, 255}, {320, 250, 0.94F, 0}};
  EXPECT_TRUE(HasColourNear(DrawCloseUp(gray, bad_beside), 50, 60, 240));
  const std::vector<BestPixel> bad_afar = {{300, 240, 0.95F, 255}, {5, 5, 0.94F, 0}};
  EXPECT_FALSE(HasColourNear(DrawCloseUp(gray, bad_afar), 50, 60, 240));
}

TEST(DrawCloseUp, StaysInsideThePicture) {
  for (const auto& [width, height] : {std::pair{640, 480}, {1, 1}, {4, 4}, {10000, 3}, {3, 5000}}) {
    const Image picture(width, height, 3, 90);
    for (const auto& [u, v] : {std::pair{0, 0}, {width - 1, height - 1}}) {
      const std::vector<BestPixel> best = {{u, v, 0.95F, 128}};
      const Image close_up = DrawCloseUp(picture, best);
      EXPECT_EQ(std::max(close_up.width(), close_up.height()), 280);
      EXPECT_GE(std::min(close_up.width(), close_up.height()), 1);
    }
  }
}

TEST(DrawCloseUp, IsEmptyWithoutBestPixels) {
  EXPECT_TRUE(DrawCloseUp(Image(10, 10, 3), {}).empty());
}

}  // namespace
}  // namespace handcraft::experiments
