// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/plan_judges.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/synthetic/demonstrations.h"
#include "lib/core/error.h"
#include "tests/datasets/synthetic/small_camera.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::Each;
using ::testing::HasSubstr;

GraspPlan SolvedPlan(std::string object_class = {}) {
  GraspPlan plan{.object_class = std::move(object_class)};
  plan.kinematics.joints = {0.0};
  plan.kinematics.costs = {0.0};
  return plan;
}

TEST(JudgeByJointValues, TellsWhatBecameOfAPlan) {
  datasets::ViewSet views;
  views.items.resize(2);
  views.items[0].object_class = "can";
  views.items[1].object_class = "box";
  ViewStudy study;
  study.associations["box"] = {"drill", "can"};
  const PlanJudge judge = JudgeByJointValues(study, views);
  const auto outcome = [&](std::size_t view, const GraspPlan& plan) {
    return judge.outcomes[judge.outcome_of(view, plan)];
  };
  EXPECT_EQ(outcome(0, SolvedPlan("can")), "nearest reached");
  EXPECT_EQ(outcome(0, SolvedPlan("drill")), "other class");
  EXPECT_EQ(outcome(1, SolvedPlan("can")), "nearest reached") << "associated";
  GraspPlan plan = SolvedPlan("drill");
  plan.rank = 2;
  EXPECT_EQ(outcome(1, plan), "next nearest reached");
  EXPECT_EQ(outcome(1, {.object_class = "drill"}), "out of reach");
  plan.rejection_distance_m = 0.1;
  plan.grasp.distance_m = 0.2;
  EXPECT_EQ(outcome(1, plan), "too far");
}

// Two views each of the objects that are regrasped, with poses shown for them.
class JudgeByTrueShapeTest : public ::testing::Test {
 protected:
  void SetUp() override {
    shown_ = synthetic::MakeDemonstrations(folder_ / "shown",
                                           {.views = {.family = synthetic::Family::kRegrasp,
                                                      .num_views = 2,
                                                      .sensor = synthetic::CloudSensor::kPerfect,
                                                      .camera = synthetic::testing::SmallCamera()},
                                            .poses_per_view = 3})
                 .set;
    views_ = datasets::ReadViewSet(folder_ / "shown");
  }

  [[nodiscard]] static GraspPlan PlanFor(const datasets::EndEffectorPose& pose) {
    GraspPlan plan = SolvedPlan();
    const Eigen::Quaterniond& q = pose.rotation;
    plan.base_from_grasp.rotation = robot::RotationFromQuaternion({q.x(), q.y(), q.z(), q.w()});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      plan.base_from_grasp.translation_m[axis] = pose.position_m[static_cast<Eigen::Index>(axis)];
    }
    return plan;
  }

  // What the judge says of the first pose shown, moved up and changed.
  template <class Change>
  [[nodiscard]] std::string OutcomeOf(double up_m, const Change& change) const {
    const PlanJudge judge = JudgeByTrueShape(views_);
    GraspPlan plan = PlanFor(shown_.items.front().pose);
    plan.base_from_grasp.translation_m[2] += up_m;
    change(plan);
    return judge.outcomes[judge.outcome_of(0, plan)];
  }
  [[nodiscard]] std::string OutcomeOf(double up_m) const {
    return OutcomeOf(up_m, [](GraspPlan&) {});
  }

  TemporaryDirectory folder_;
  datasets::DemonstrationSet shown_;
  datasets::ViewSet views_;
};

TEST_F(JudgeByTrueShapeTest, EveryPoseThatWasShownHoldsTheObjectItWasShownFor) {
  const PlanJudge judge = JudgeByTrueShape(views_);
  std::vector<std::string> outcomes;
  for (const datasets::Demonstration& shown : shown_.items) {
    for (std::size_t view = 0; view < views_.items.size(); ++view) {
      if (views_.items[view].image != shown.view) continue;
      outcomes.push_back(judge.outcomes[judge.outcome_of(view, PlanFor(shown.pose))]);
    }
  }
  EXPECT_EQ(outcomes.size(), shown_.items.size());
  EXPECT_THAT(outcomes, Each("held"));
}

TEST_F(JudgeByTrueShapeTest, NamesWhatFails) {
  EXPECT_EQ(OutcomeOf(1.0), "nothing held");
  EXPECT_EQ(OutcomeOf(-0.5), "near the table");
  EXPECT_EQ(OutcomeOf(0.0, [](GraspPlan& plan) { plan.kinematics = {}; }), "out of reach");
  EXPECT_EQ(OutcomeOf(0.0,
                      [](GraspPlan& plan) {
                        plan.rejection_distance_m = 0.1;
                        plan.grasp.distance_m = 0.2;
                      }),
            "too far");
}

TEST_F(JudgeByTrueShapeTest, OneOutcomeIsRight) {
  const PlanJudge judge = JudgeByTrueShape(views_);
  ASSERT_EQ(judge.is_right.size(), judge.outcomes.size());
  for (std::size_t i = 0; i < judge.outcomes.size(); ++i) {
    EXPECT_EQ(judge.is_right[i], judge.outcomes[i] == "held");
  }
}

TEST_F(JudgeByTrueShapeTest, SaysThatTheTruthIsNotKnown) {
  for (datasets::ObjectView& view : views_.items) view.scene.clear();
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(OutcomeOf(0.0)), Error, HasSubstr("the view has no scene"));
}

}  // namespace
}  // namespace handcraft::experiments
