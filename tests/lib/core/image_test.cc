// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/image.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft {
namespace {

TEST(BasicImage, StoresPixelsRowByRow) {
  Image image(3, 2, 3);
  image.At(2, 1, 0) = 7;
  EXPECT_EQ(image.values()[1 * 9 + 2 * 3 + 0], 7);
  EXPECT_EQ(image.View().At(2, 1), 7);
  EXPECT_EQ(image.View().Row(1), image.values().data() + 9);
}

TEST(BasicImage, FillsWithTheGivenValue) {
  const FloatImage image(2, 2, 1, 0.5F);
  EXPECT_EQ(image.At(1, 1), 0.5F);
}

TEST(BasicImage, MayBeEmptyButNotNegative) {
  EXPECT_TRUE(Image(0, 5).empty());
  EXPECT_THROW(Image(-1, 5), std::logic_error);
}

}  // namespace
}  // namespace handcraft
