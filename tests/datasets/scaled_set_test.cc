// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/scaled_set.h"

#include <filesystem>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/read_tree.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

class ProvideScaledSetTest : public ::testing::Test {
 protected:
  [[nodiscard]] LabelledImageSet Scaled(double scale, const std::string& name, int threads = 1) {
    return ProvideScaledSet(set_, scale, folder_ / name, threads, {});
  }

  testing::TemporaryDirectory folder_;
  LabelledImageSet set_ = testing::MakeSet(folder_.path());
};

TEST_F(ProvideScaledSetTest, ScalesPicturesAndMasksAndKeepsTheRest) {
  const LabelledImageSet half = Scaled(0.5, "half");
  ASSERT_EQ(half.items.size(), set_.items.size());
  for (std::size_t i = 0; i < half.items.size(); ++i) {
    const LabelledPicture picture = ReadLabelledPicture(half, i);
    EXPECT_EQ(picture.image.width(), 20);
    EXPECT_EQ(picture.image.height(), 15);
    EXPECT_EQ(picture.mask.width(), 20);
    EXPECT_EQ(half.items[i].instance, set_.items[i].instance);
    EXPECT_EQ(half.items[i].object_class, set_.items[i].object_class);
    EXPECT_EQ(half.items[i].split, set_.items[i].split);
  }
  EXPECT_EQ(ReadLabelledPicture(Scaled(1.5, "more"), 0).image.width(), 60);
}

TEST_F(ProvideScaledSetTest, AveragesAreasWhenShrinking) {
  const LabelledImageSet half = Scaled(0.5, "half");
  const Image before = ReadLabelledPicture(set_, 0).image;
  const Image after = ReadLabelledPicture(half, 0).image;
  for (int channel = 0; channel < 3; ++channel) {
    int sum = 0;
    for (const int v : {6, 7}) {
      for (const int u : {10, 11}) sum += before.At(u, v, channel);
    }
    EXPECT_NEAR(after.At(5, 3, channel), sum / 4.0, 1.0);  // rounded to a whole number
  }
}

TEST_F(ProvideScaledSetTest, KeepsTheValuesOfMasks) {
  const Image mask = ReadMask(Scaled(0.75, "s"), 0);
  const std::set<int> values(mask.values().begin(), mask.values().end());
  EXPECT_EQ(values, (std::set<int>{0, 128, 255}));
}

TEST_F(ProvideScaledSetTest, GivesTheSameBytesForAnyNumberOfThreads) {
  static_cast<void>(Scaled(0.5, "one"));
  static_cast<void>(Scaled(0.5, "three", 3));
  EXPECT_EQ(testing::ReadTree(folder_ / "three"), testing::ReadTree(folder_ / "one"));
}

TEST_F(ProvideScaledSetTest, ReadsWhatIsThere) {
  const std::string fingerprint = Fingerprint(Scaled(0.5, "half"));
  for (const LabelledImage& item : set_.items) std::filesystem::remove(set_.root / item.image);
  EXPECT_EQ(Fingerprint(Scaled(0.5, "half")), fingerprint);
}

TEST_F(ProvideScaledSetTest, LeavesNothingBehindWhenAPictureIsMissing) {
  std::filesystem::remove(folder_ / "c.png");
  EXPECT_THROWS_MESSAGE(Scaled(0.5, "half"), Error, ::testing::HasSubstr("c.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "half"));
}

TEST_F(ProvideScaledSetTest, RefusesScalesOutOfRange) {
  EXPECT_THROW(static_cast<void>(Scaled(0.0, "s")), std::logic_error);
  EXPECT_THROW(static_cast<void>(Scaled(11.0, "s")), std::logic_error);
}

}  // namespace
}  // namespace handcraft::datasets
