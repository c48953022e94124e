// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/grasp_planning/grasp_library_input.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/datasets/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using datasets::testing::WriteSmallSet;
using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

TEST(GraspLibraryInput, DescribesViewsAndPoses) {
  const TemporaryDirectory folder;
  WriteSmallSet(folder / "views", {0.0, 30.0, 60.0});
  WriteSmallSet(folder / "shown", {0.0, 60.0}, 0.5);
  const GraspLibraryInput input =
      ReadGraspLibraryInput(datasets::ReadViewSet(folder / "views"), folder / "shown");
  const grasp_library::TrainingSet set = DescribeInput(input, 1, {});
  EXPECT_EQ(set.classes, (std::vector<std::string>{"board", "wedge"}));
  ASSERT_EQ(set.views.size(), 6U);
  ASSERT_EQ(set.poses.size(), 12U);
  EXPECT_EQ(set.views[4].object_class, 1U);
  EXPECT_NEAR(set.views[4].angle_rad, std::numbers::pi / 6.0, 1e-15);
  EXPECT_EQ(set.poses[3].number, 3);
  EXPECT_NEAR(set.poses[3].angle_rad, std::numbers::pi / 3.0, 1e-15);
  EXPECT_NEAR(set.poses[3].mean_m[0], 0.5, 0.03);  // of the place where it was shown
  EXPECT_EQ(set.poses[4].position_m[1], 0.02);
  EXPECT_EQ(set.poses[4].rotation, (features::Quaternion{0, 0.6, 0, 0.8}));
}

TEST(GraspLibraryInput, RefusesWhatDoesNotFit) {
  const TemporaryDirectory folder;
  WriteSmallSet(folder / "views", {0.0});
  WriteSmallSet(folder / "shown", {0.0});
  const auto read = [&] {
    static_cast<void>(
        ReadGraspLibraryInput(datasets::ReadViewSet(folder / "views"), folder / "shown"));
  };
  datasets::ViewSet views = datasets::ReadViewSet(folder / "views");
  views.items.pop_back();
  datasets::WriteViews(views);
  EXPECT_THROWS_MESSAGE(
      read(), Error, HasSubstr("poses are shown for class wedge, which has no view"));
  views.items[0].angle_deg.reset();
  datasets::WriteViews(views);
  EXPECT_THROWS_MESSAGE(read(), Error, HasSubstr("the view has no angle_deg"));
}

}  // namespace
}  // namespace handcraft::experiments
