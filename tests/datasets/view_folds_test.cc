// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/view_folds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

ObjectView View(const std::string& name, const std::string& instance, double angle_deg) {
  return {.image = instance + ".png",
          .object_mask = "m",
          .object_class = name,
          .instance = instance,
          .angle_deg = angle_deg,
          .split = "train"};
}

TEST(ViewFolds, ClassesInTheOrderInWhichTheyCome) {
  const ViewSet set{.root = "r",
                    .items = {View("mug", "a", 0), View("can", "b", 0), View("mug", "a", 9)}};
  const ViewClasses classes = ClassesOf(set);
  EXPECT_THAT(classes.names, ElementsAre("mug", "can"));
  EXPECT_THAT(classes.values, ElementsAre(0U, 1U, 0U));
}

TEST(ViewFolds, NeighbouringAnglesOfOneInstanceGoTogether) {
  ViewSet set{.root = "r", .items = {}};
  for (const double angle : {0.0, 10.0, 89.9, 90.0, 180.0, 359.9}) {
    set.items.push_back(View("mug", "a", angle));
  }
  EXPECT_THAT(GroupedFolds(set, 4), ElementsAre(0U, 0U, 0U, 1U, 2U, 3U));
}

TEST(ViewFolds, InstancesGoTogetherWhereEachClassHasSeveral) {
  ViewSet set{.root = "r",
              .items = {View("mug", "a", 0),
                        View("mug", "b", 0),
                        View("mug", "a", 90),
                        View("can", "c", 0),
                        View("can", "d", 0),
                        View("mug", "e", 0)}};
  EXPECT_THAT(GroupedFolds(set, 4), ElementsAre(0U, 1U, 0U, 0U, 1U, 0U));
}

TEST(ViewFolds, ViewsWithoutAnAngleAreDealtOut) {
  ViewSet set{.root = "r",
              .items = {View("mug", "a", 0), View("mug", "a", 0), View("can", "c", 0)}};
  for (ObjectView& view : set.items) view.angle_deg.reset();
  EXPECT_THAT(GroupedFolds(set, 2), ElementsAre(0U, 1U, 0U));
}

TEST(ViewFolds, OneFoldIsNone) {
  EXPECT_THROWS_MESSAGE(static_cast<void>(GroupedFolds({}, 1)),
                        Error,
                        HasSubstr("the number of folds is 1; it must be at least 2"));
}

TEST(ViewFolds, ASplitWithoutViewsIsNamed) {
  const ViewSet set{.root = "r", .items = {View("mug", "a", 0)}};
  EXPECT_EQ(OnlySplit(set, "train").items.size(), 1U);
  EXPECT_EQ(OnlySplit(set, "").items.size(), 1U);
  EXPECT_THROWS_MESSAGE(static_cast<void>(OnlySplit(set, "test")),
                        Error,
                        HasSubstr("no view is in the split 'test'; there are: train"));
}

}  // namespace
}  // namespace handcraft::datasets
