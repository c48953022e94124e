// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/view_studies/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::MakeSmallViews;
using handcraft::testing::TemporaryDirectory;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ProvideViews, ReadsAFolder) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = MakeSmallViews(folder / "set", 1);
  const ViewData data = ProvideViews({.folder = (folder / "set").string()}, folder / "made", 1, {});
  EXPECT_THAT(data.classes, ElementsAre("water_bottle", "spray_bottle", "coffee_can", "drill"));
  EXPECT_EQ(data.NumViews(), 4U);
  EXPECT_EQ(data.View(2).image, set.items[2].image);
  EXPECT_THROW(static_cast<void>(data.View(4)), std::out_of_range);
  EXPECT_FALSE(std::filesystem::exists(folder / "made"));
  EXPECT_THROW(static_cast<void>(ProvideViews({.folder = "missing"}, folder / "made", 1, {})),
               Error);
}

TEST(LabelNumbers, NumbersByTheClassesGiven) {
  const std::vector<std::string> classes = {"mug", "can"};
  EXPECT_THAT(LabelNumbers({"can", "mug", "can"}, classes), ElementsAre(1U, 0U, 1U));
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(LabelNumbers({"pan"}, classes)),
      Error,
      HasSubstr("the class \"pan\" is none of those that were learnt: mug, can (say in"));
}

}  // namespace
}  // namespace handcraft::experiments
