// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/grasp_planning/grasp_planner.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/model_io/grasp_library_models.h"
#include "lib/model_io/object_class_models.h"
#include "lib/robot/nearest_attempt.h"
#include "tests/datasets/small_views.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kRobots = HANDCRAFT_SOURCE_DIR "/models/robots/";
const std::string kArm = kRobots + "dual_wam/right_arm.toml";
const std::string kLeftArm = kRobots + "dual_wam/left_arm.toml";

// A board seen every 30° of half a turn, one pose shown for it unturned: forwards and down, 2 cm
// above p_m. So for each of several classes.
features::GraspLibrary OneGrasp(int num_classes = 1) {
  features::GraspLibrary library;
  library.view_begins = library.angle_begins = library.pose_begins = {0};
  for (int c = 1; c <= num_classes; ++c) {
    for (int i = 0; i < 6; ++i) {
      const double angle_rad = i * std::numbers::pi / 6.0;
      library.view_angles_rad.push_back(angle_rad);
      library.view_normals.insert(library.view_normals.end(),
                                  {-std::sin(angle_rad), std::cos(angle_rad), 0.0});
      library.view_moments.insert(library.view_moments.end(), features::kNumMoments, 0.1);
    }
    library.view_begins.push_back(6 * c);
    library.moment_scales.insert(library.moment_scales.end(), features::kNumMoments, 1e6);
    library.angle_begins.push_back(c);
    features::testing::AddShownAngle(library, 0.0, {{0.0, 0.0, 0.02}}, {{0.0, 0.8, 0.0, 0.6}});
  }
  library.rejection_distance_m = 0.2;
  return library;
}

class GraspPlannerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    WriteLibrary({.classes = {"board"}, .robot = "dual_wam", .joints = RightJoints()});
    options_.grasp_library = folder_ / "library.safetensors";
    options_.robot = kArm;
    options_.object_class = "board";
    options_.grasp_pixel = {8, 6};
    const datasets::LoadedView view = datasets::testing::SmallView(0.0, 0.0, 0);
    scene_ = {.image = view.image, .cloud = *view.cloud, .object_mask = view.object_mask};
  }

  static std::vector<std::string> RightJoints() {
    std::vector<std::string> names;
    for (int i = 1; i <= 7; ++i) names.push_back("right_j" + std::to_string(i));
    return names;
  }
  void WriteLibrary(const model_io::GraspLibraryNames& names) const {
    WriteFileAtomically(folder_ / "library.safetensors",
                        model_io::Serialise(model_io::MakeGraspLibraryModel(
                            OneGrasp(static_cast<int>(names.classes.size())), names, {})));
  }
  // Three poses, of which the arm reaches the farthest alone.
  void WriteUpsideDownFirst(double rejection_distance_m = 0.5) const {
    features::GraspLibrary library = OneGrasp();
    for (auto* rows : {&library.positions_m, &library.rotations, &library.shown_angles_rad}) {
      rows->clear();
    }
    library.numbers.clear();
    library.shown_means_m.clear();
    library.pose_begins = {0};
    features::testing::AddShownAngle(library,
                                     0.0,
                                     {{0.0, 0.0, 0.30}, {0.0, 0.0, 0.05}, {0.0, 0.0, 0.06}},
                                     {{0.0, 0.8, 0.0, 0.6}, {0, 0, 0, 1}, {0, 0, 0, 1}});
    library.rejection_distance_m = rejection_distance_m;
    WriteFileAtomically(
        folder_ / "library.safetensors",
        model_io::Serialise(model_io::MakeGraspLibraryModel(
            library, {.classes = {"board"}, .robot = "dual_wam", .joints = RightJoints()}, {})));
  }
  [[nodiscard]] GraspPlan Plan() const { return GraspPlanner(options_).Plan(scene_); }

  testing::TemporaryDirectory folder_;
  GraspPlanOptions options_;
  GraspScene scene_;
};

TEST_F(GraspPlannerTest, BringsTheHandAndNotTheFlangeToThePoint) {
  options_.position = GraspPosition::kGraspPoint;
  GraspPlanner planner(options_);
  const GraspPlan plan = planner.Plan(scene_);
  EXPECT_EQ(plan.u_px, 8);
  EXPECT_EQ(plan.v_px, 6);
  EXPECT_EQ(plan.object_class, "board");
  EXPECT_EQ(plan.grasp.object_angle_rad, 0.0);
  ASSERT_TRUE(plan.kinematics.IsSolved());
  const robot::Pose tip = robot::ForwardKinematics(planner.chain(), plan.kinematics.Solution(0));
  const robot::Vector3 hand = robot::Apply(tip, {0.0, 0.0, 0.175});
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(hand[axis], plan.point_m[axis], 1e-8);
  // The approach axis of the demonstration, (0.96, 0, −0.28), as the board is not turned.
  const robot::Vector3 approach = robot::Column(tip.rotation, 2);
  EXPECT_NEAR(approach[0], 0.96, 1e-8);
  EXPECT_NEAR(approach[2], -0.28, 1e-8);
}

TEST_F(GraspPlannerTest, TellsTheTimeOfEachLayer) {
  const GraspPlan plan = Plan();
  std::vector<std::string_view> names;
  for (const PlanStage& stage : plan.stages) {
    names.push_back(stage.name);
    EXPECT_GE(stage.time_ms, 0.0);
  }
  EXPECT_EQ(names,
            (std::vector<std::string_view>{"grasp point",
                                           "object class",
                                           "object rotation",
                                           "nearest demonstration",
                                           "inverse kinematics"}));
}

TEST_F(GraspPlannerTest, TurnsTheHandWithTheObject) {
  const datasets::LoadedView turned = datasets::testing::SmallView(30.0, 0.0, 0);
  scene_.cloud = *turned.cloud;
  const GraspPlan plan = Plan();
  EXPECT_NEAR(plan.grasp.object_angle_rad, std::numbers::pi / 6.0, 1e-12);
  EXPECT_NEAR(plan.grasp.turn_rad, -std::numbers::pi / 6.0, 1e-12);
  const robot::Vector3 approach = robot::Column(plan.base_from_grasp.rotation, 2);
  EXPECT_NEAR(std::atan2(approach[1], approach[0]), std::numbers::pi / 6.0, 1e-9);
}

TEST_F(GraspPlannerTest, PutsTheHandWhereItWasShown) {
  const GraspPlan plan = Plan();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(plan.base_from_grasp.translation_m[axis], plan.grasp.position_m[axis]);
  }
  EXPECT_GT(std::fabs(plan.grasp.position_m[2] - plan.point_m[2]), 1e-3);
}

TEST_F(GraspPlannerTest, MayPutTheHandAtTheGraspPoint) {
  options_.position = GraspPosition::kGraspPoint;
  const GraspPlan plan = Plan();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(plan.base_from_grasp.translation_m[axis], plan.point_m[axis]);
  }
}

TEST_F(GraspPlannerTest, AClickBesideTheObjectTakesTheNearestMeasuredPixel) {
  options_.grasp_pixel = {0, 6};
  const GraspPlan plan = Plan();
  EXPECT_EQ(plan.u_px, 2);
  EXPECT_EQ(plan.v_px, 6);
}

TEST_F(GraspPlannerTest, AModelMayFindThePoint) {
  WriteFileAtomically(folder_ / "points.safetensors",
                      model_io::Serialise(testing::SomeGraspPointModel("edges54")));
  options_.grasp_pixel.reset();
  options_.grasp_point_model = folder_ / "points.safetensors";
  const GraspPlan plan = Plan();
  EXPECT_NE(scene_.object_mask.At(plan.u_px, plan.v_px), 0);
  EXPECT_TRUE(plan.probability.has_value());
}

TEST_F(GraspPlannerTest, AModelMaySayTheClass) {
  model_io::ObjectClassModel model = testing::SomeObjectClasses();
  model.outlier_step = 0.0;
  model.classes = {"board", "mug", "can"};
  const datasets::MaskedCloud example =
      datasets::TakeObjectCloud(scene_.cloud, scene_.object_mask, {.outlier_step = 0.0});
  WriteFileAtomically(
      folder_ / "classes.safetensors",
      model_io::Serialise(model_io::MakeObjectClassModel(model, example.View(), {})));
  options_.object_class_model = folder_ / "classes.safetensors";
  EXPECT_THROWS_MESSAGE(GraspPlanner{options_}, Error, HasSubstr("told twice"));
  options_.object_class.clear();
  EXPECT_THROWS_MESSAGE(
      GraspPlanner{options_}, Error, HasSubstr("the grasp library knows no class 'mug'"));
  WriteLibrary({.classes = model.classes, .robot = "dual_wam", .joints = RightJoints()});
  const LoadedModel loaded = LoadModel(folder_ / "classes.safetensors");
  CloudClassifier classifier(loaded.get());
  EXPECT_EQ(Plan().object_class, model.classes[classifier.Classify(example).number]);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < scene_.cloud.points.size(); ++i) {
    if (i != 6 * 16 + 8) scene_.cloud.points[i] = {nan, nan, nan};
  }
  EXPECT_THROWS_MESSAGE(Plan(), Error, HasSubstr("fewer than 3 points of the object"));
}

TEST_F(GraspPlannerTest, AnObjectThatIsNoneOfTheClassesIsRefusedOrTakenForTheNearest) {
  model_io::ObjectClassModel model = testing::SomeObjectClasses();
  model.outlier_step = 0.0;
  model.classes = {"board", "mug", "can"};
  WriteLibrary({.classes = model.classes, .robot = "dual_wam", .joints = RightJoints()});
  options_.object_class.clear();
  options_.object_class_model = folder_ / "classes.safetensors";
  const auto write = [&](std::optional<double> threshold) {
    model.svm.rejection_threshold = threshold;
    const datasets::MaskedCloud example =
        datasets::TakeObjectCloud(scene_.cloud, scene_.object_mask, {.outlier_step = 0.0});
    WriteFileAtomically(
        options_.object_class_model,
        model_io::Serialise(model_io::MakeObjectClassModel(model, example.View(), {})));
  };
  write({});
  const GraspPlan sure = Plan();
  ASSERT_TRUE(sure.class_margin.has_value());
  EXPECT_FALSE(sure.is_class_rejected);
  write(*sure.class_margin + 1.0);
  EXPECT_THROWS_MESSAGE(Plan(),
                        Error,
                        AllOf(HasSubstr("classes.safetensors"),
                              HasSubstr("none of the model's classes"),
                              HasSubstr("the nearest is '" + sure.object_class + "'"),
                              HasSubstr("--nearest-class")));
  options_.take_nearest_class = true;
  const GraspPlan nearest = Plan();
  EXPECT_TRUE(nearest.is_class_rejected);
  EXPECT_EQ(nearest.object_class, sure.object_class);
  EXPECT_EQ(nearest.class_margin, sure.class_margin);
  EXPECT_EQ(nearest.kinematics.best.joints, sure.kinematics.best.joints);
  write(*sure.class_margin);  // not below it
  EXPECT_FALSE(Plan().is_class_rejected);
}

TEST_F(GraspPlannerTest, RefusesAnArmThatDidNotShowTheGrasps) {
  options_.robot = kLeftArm;
  EXPECT_THROWS_MESSAGE(GraspPlanner{options_},
                        Error,
                        AllOf(HasSubstr("left_j1"),
                              HasSubstr("the grasps were shown by joints right_j1"),
                              HasSubstr("any_arm")));
  options_.robot = kRobots + "franka_panda/panda.toml";
  EXPECT_THROWS_MESSAGE(
      GraspPlanner{options_}, Error, HasSubstr("the grasps were shown by robot dual_wam"));
  options_.robot = kLeftArm;
  options_.any_arm = true;
  EXPECT_NO_THROW(GraspPlanner{options_});
}

TEST_F(GraspPlannerTest, RefusesWhatItDoesNotKnow) {
  options_.object_class = "teapot";
  EXPECT_THROWS_MESSAGE(
      GraspPlanner{options_}, Error, AllOf(HasSubstr("'teapot'"), HasSubstr("there are: board")));
  options_.object_class = "board";
  options_.grasp_library = HANDCRAFT_SOURCE_DIR "/tests/data/models/v1_svm.safetensors";
  EXPECT_THROWS_MESSAGE(
      GraspPlanner{options_}, Error, HasSubstr("a model of kind svm; grasp_library is due"));
}

TEST_F(GraspPlannerTest, RefusesACloudOfTwoPoints) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (int v = 0; v < 12; ++v) {
    for (int u = 0; u < 16; ++u) {
      if (v == 6 && (u == 8 || u == 9)) continue;
      scene_.cloud.points[static_cast<std::size_t>(16 * v + u)] = {nan, nan, nan};
    }
  }
  const auto refused = [this](const std::string& reason, const std::string& remedy) {
    try {
      static_cast<void>(Plan());
      FAIL() << "planned";
    } catch (const Error& error) {
      EXPECT_EQ(error.details().kind, Error::Kind::kNoResult);
      EXPECT_THAT(error.details().reason, HasSubstr(reason));
      EXPECT_THAT(error.details().remedy, AllOf(HasSubstr(remedy), Not(HasSubstr("click"))));
    }
  };
  refused("fewer than 3 points of the object were measured", "look at it from elsewhere");
  scene_.cloud.points.assign(16 * 12, Eigen::Vector3f(nan, nan, nan));
  refused("fewer than 3 points of the object were measured", "look at it from elsewhere");
  scene_.object_mask = Image(16, 12);
  refused("no pixel of the mask is the object's", "--mask that is not 0");
  const datasets::LoadedView whole = datasets::testing::SmallView(0.0, 0.0, 0);
  scene_.cloud = *whole.cloud;
  scene_.object_mask.At(8, 6) = scene_.object_mask.At(9, 6) = 255;
  refused("fewer than 3 points of the object were measured", "another --mask");
  scene_.object_mask.At(7, 6) = 255;  // three in a row
  refused("the object's cloud has its points on one line", "another --mask");
}

TEST_F(GraspPlannerTest, RefusesScenesThatDoNotFit) {
  options_.grasp_pixel = {16, 0};
  EXPECT_THROWS_MESSAGE(Plan(), Error, HasSubstr("16,0 is outside the picture of 16 × 12"));
  scene_.image = Image(8, 8, 3);
  EXPECT_THROWS_MESSAGE(Plan(), Error, HasSubstr("the picture has 8 × 8 pixels"));
}

TEST_F(GraspPlannerTest, SaysHowFarAnUnreachableGraspIs) {
  WriteUpsideDownFirst();
  const datasets::LoadedView far = datasets::testing::SmallView(0.0, 3.0, 0);
  scene_.cloud = *far.cloud;
  const GraspPlan plan = Plan();
  EXPECT_FALSE(plan.kinematics.IsSolved());
  EXPECT_EQ(plan.num_attempts, 3U);
  EXPECT_GT(plan.kinematics.best.error.position_m, 1.0);
  // Of all three it is the one that the arm comes nearest to.
  GraspPlanner planner(options_);
  robot::InverseKinematicsResult attempt;
  robot::MakeInverseKinematics(planner.chain())->Solve(plan.base_from_tip, {}, attempt);
  EXPECT_EQ(plan.kinematics.best.joints, attempt.best.joints);
  options_.max_attempts = 1;
  const GraspPlan first = Plan();
  EXPECT_EQ(first.rank, 0U);
  EXPECT_EQ(first.num_attempts, 1U);
  EXPECT_GE(robot::SquaredError(first.kinematics.best.error),
            robot::SquaredError(plan.kinematics.best.error));
}

// The nearest demonstrations come from below the table.
TEST_F(GraspPlannerTest, TriesTheNextNearestWhereTheNearestIsOutOfReach) {
  options_.position = GraspPosition::kGraspPoint;
  WriteUpsideDownFirst();
  const GraspPlan plan = Plan();
  ASSERT_TRUE(plan.kinematics.IsSolved());
  EXPECT_EQ(plan.rank, 2U);
  EXPECT_EQ(plan.num_attempts, 3U);
  EXPECT_EQ(plan.grasp.number, 0);
  const robot::Vector3 approach = robot::Column(plan.base_from_grasp.rotation, 2);
  EXPECT_NEAR(approach[0], 0.96, 1e-8);
  options_.max_attempts = 2;
  EXPECT_FALSE(Plan().kinematics.IsSolved());
  EXPECT_EQ(Plan().num_attempts, 2U);
}

TEST_F(GraspPlannerTest, TriesNoneThatIsTooFar) {
  options_.position = GraspPosition::kGraspPoint;
  WriteUpsideDownFirst();
  options_.max_attempt_distance_m = 0.9 * Plan().grasp.distance_m;
  EXPECT_EQ(Plan().num_attempts, 2U);
  EXPECT_FALSE(Plan().kinematics.IsSolved());
  options_.max_attempt_distance_m = 1e-9;  // the first is tried however far it is
  EXPECT_EQ(Plan().num_attempts, 1U);
  options_.max_attempt_distance_m = 0.0;
  WriteUpsideDownFirst(0.01);  // the library's own limit
  EXPECT_EQ(Plan().num_attempts, 1U);
  EXPECT_TRUE(Plan().IsRejected());
}

TEST_F(GraspPlannerTest, RefusesReferencesOutsideTheLimits) {
  options_.reference_joints = {9, 0, 0, 0, 0, 0, 0};
  EXPECT_THROWS_MESSAGE(GraspPlanner{options_}, Error, HasSubstr("right_j1"));
}

TEST(MaskAboveTable, KeepsWhatStandsOnTheTable) {
  datasets::OrganisedCloud cloud;
  cloud.width = 80;
  cloud.height = 60;
  for (int v = 0; v < 60; ++v) {
    for (int u = 0; u < 80; ++u) {
      const bool is_object = u >= 30 && u < 50 && v >= 20 && v < 40;
      cloud.points.emplace_back(0.01F * static_cast<float>(u),
                                0.01F * static_cast<float>(v),
                                is_object ? 0.1F + 0.001F * static_cast<float>(u % 7) : 0.0F);
    }
  }
  const Image mask = MaskAboveTable(cloud);
  EXPECT_EQ(mask.At(40, 30), 255);
  EXPECT_EQ(mask.At(10, 30), 0);
  cloud.points.assign(cloud.points.size(), Eigen::Vector3f::Constant(NAN));
  EXPECT_THROWS_MESSAGE(MaskAboveTable(cloud), Error, HasSubstr("nothing stands on the table"));
}

}  // namespace
}  // namespace handcraft::experiments
