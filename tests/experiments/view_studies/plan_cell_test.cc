// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/plan_cell.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/grasp_planning/grasp_library_input.h"
#include "lib/core/error.h"
#include "tests/datasets/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PlanGraspsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    study_.task = ViewTask::kGraspPlan;
    cell_.settings.classes.descriptor.grid_size = 8;
    cell_.settings.classes.outlier_step = 0.0;
    cell_.settings.grasps.robot = HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/right_arm.toml";
  }
  ViewCellResult Plan(double x_m) {
    datasets::testing::WriteSmallSet(folder_ / "set", {0.0, 30.0, 60.0}, x_m);
    const datasets::ViewSet views = datasets::ReadViewSet(folder_ / "set");
    return PlanFor(views, views);
  }
  ViewCellResult PlanFor(const datasets::ViewSet& views, const datasets::ViewSet& asked) {
    const grasp_library::TrainingSet shown =
        DescribeInput(ReadGraspLibraryInput(views, folder_ / "set"), 1, {});
    return PlanGrasps(study_, cell_, {views, shown, asked}, folder_ / "models", {});
  }

  testing::TemporaryDirectory folder_;
  ViewStudy study_;
  ViewCell cell_{.id = "click", .method = "click", .factors = {}, .settings = {}};
};

TEST_F(PlanGraspsTest, TellsWhatBecameOfPlansAndTheTimeOfEachLayer) {
  const ViewCellResult result = Plan(0.0);
  EXPECT_THAT(result.answers.rows, ElementsAre("board", "wedge"));
  ASSERT_EQ(result.groups.size(), 3U);
  EXPECT_EQ(result.groups[2].num_views, 6U);
  EXPECT_EQ(result.groups[2].num_right, 6U);
  std::vector<std::string> names;
  for (const TimeFigure& time : result.times) names.push_back(time.name);
  EXPECT_THAT(names,
              ElementsAre("grasp_point_ms",
                          "object_class_ms",
                          "object_rotation_ms",
                          "nearest_demonstration_ms",
                          "inverse_kinematics_ms",
                          "all_ms",
                          "all_95_percent_ms",
                          "plan_processor_ms"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "models/object_class.safetensors"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "models/grasp_library.safetensors"));
}

TEST_F(PlanGraspsTest, CountsWhatIsOutOfReachAndTooFar) {
  const ViewCellResult unreached = Plan(3.0);
  EXPECT_EQ(unreached.groups[2].num_right, 0U);
  EXPECT_EQ(unreached.answers.columns[2], "out of reach");
  EXPECT_EQ(unreached.answers.counts[0][2], 3U);
  cell_.settings.grasps.max_distance_m = 1e-6;
  const ViewCellResult rejected = Plan(0.0);
  EXPECT_EQ(rejected.answers.columns[3], "too far");
  EXPECT_EQ(rejected.answers.counts[1][3], 3U);
}

TEST_F(PlanGraspsTest, ViewsThatAllowOfNoPlanAreCounted) {
  datasets::testing::WriteSmallSet(folder_ / "set", {0.0, 30.0, 60.0}, 0.0);
  const datasets::ViewSet views = datasets::ReadViewSet(folder_ / "set");
  datasets::ViewSet asked = views;
  datasets::OrganisedCloud cloud = *datasets::ReadView(views, 0).cloud;
  cloud.points.assign(cloud.points.size(),
                      Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  asked.items[0].cloud = "clouds/empty.pcd";
  datasets::WritePcd(views.root / asked.items[0].cloud, cloud);
  const ViewCellResult result = PlanFor(views, asked);
  EXPECT_EQ(result.answers.columns.back(), "no plan");
  EXPECT_EQ(result.answers.counts[0].back(), 1U);
  EXPECT_EQ(result.groups.back().num_right, 5U);
}

TEST_F(PlanGraspsTest, AClassMayBeToldAndAssociated) {
  datasets::testing::WriteSmallSet(folder_ / "set", {0.0, 30.0, 60.0}, 0.0);
  const datasets::ViewSet views = datasets::ReadViewSet(folder_ / "set");
  datasets::ViewSet novel = views;
  for (datasets::ObjectView& view : novel.items) view.object_class = "plank";
  EXPECT_EQ(PlanFor(views, novel).groups.back().num_right, 0U) << "nothing is right for it";
  cell_.settings.grasps.is_class_told = true;
  study_.associations["plank"] = {"board"};
  const ViewCellResult result = PlanFor(views, novel);
  EXPECT_THAT(result.answers.rows, ElementsAre("plank"));
  EXPECT_EQ(result.groups.back().num_right, 6U) << "the wedges' too, by what is told";
}

TEST_F(PlanGraspsTest, AClickMayBeOnTheObject) {
  datasets::testing::WriteSmallSet(folder_ / "set", {0.0, 30.0, 60.0}, 0.0);
  const datasets::ViewSet views = datasets::ReadViewSet(folder_ / "set");
  cell_.settings.grasps.click = GraspClick::kObject;
  EXPECT_EQ(PlanFor(views, views).groups.back().num_right, 6U);
}

TEST_F(PlanGraspsTest, NamesARobotThatIsNotThere) {
  cell_.settings.grasps.robot = "nowhere.toml";
  EXPECT_THROWS_MESSAGE(Plan(0.0), Error, HasSubstr("nowhere.toml"));
}

}  // namespace
}  // namespace handcraft::experiments
