// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/colour.h"

#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace handcraft::features {
namespace {

TEST(ToYcbcr, KnowsTheCorners) {
  const Ycbcr white = ToYcbcr(255, 255, 255);
  EXPECT_EQ(white.y, 255);
  EXPECT_EQ(white.cb, 128);
  EXPECT_EQ(white.cr, 128);
  const Ycbcr red = ToYcbcr(255, 0, 0);
  EXPECT_EQ(red.y, 76);
  EXPECT_EQ(red.cr, 255);
}

// Every fifth value of each channel and the extremes: 140608 colours.
TEST(ToYcbcr, EqualsOpenCv) {
  std::vector<cv::Vec3b> colours;
  for (int b = 0; b < 260; b += 5) {
    for (int g = 0; g < 260; g += 5) {
      for (int r = 0; r < 260; r += 5) {
        colours.emplace_back(
            cv::saturate_cast<uchar>(b), cv::saturate_cast<uchar>(g), cv::saturate_cast<uchar>(r));
      }
    }
  }
  const cv::Mat bgr(1, static_cast<int>(colours.size()), CV_8UC3, colours.data());
  cv::Mat ycrcb;
  cv::cvtColor(bgr, ycrcb, cv::COLOR_BGR2YCrCb);
  int num_different = 0;
  for (int i = 0; i < bgr.cols; ++i) {
    const auto& colour = colours[static_cast<std::size_t>(i)];
    const Ycbcr ours = ToYcbcr(colour[2], colour[1], colour[0]);
    const auto& theirs = ycrcb.at<cv::Vec3b>(0, i);
    num_different += ours.y != theirs[0] || ours.cr != theirs[1] || ours.cb != theirs[2];
  }
  EXPECT_EQ(num_different, 0);
}

}  // namespace
}  // namespace handcraft::features
