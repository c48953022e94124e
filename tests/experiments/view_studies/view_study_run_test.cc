// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/synthetic/demonstrations.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/small_views.h"
#include "tests/experiments/view_studies/small_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;
using handcraft::testing::MakeSmallViewStudy;
using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(RunViewStudy, SameBytesForAnyThreadsAndASecondTime) {
  const TemporaryDirectory folder;
  const ViewStudy study = MakeSmallViewStudy(folder / "views", ViewTask::kObjectClass);
  const ViewStudyRun run = RunViewStudy(study, {.out = folder / "one"});
  static_cast<void>(RunViewStudy(study, {.out = folder / "two", .num_threads = 2}));
  static_cast<void>(RunViewStudy(study, {.out = folder / "one"}));
  ASSERT_EQ(run.results.size(), 2U);
  EXPECT_THAT(ReadTextFile(folder / "one/results.csv"),
              AllOf(HasSubstr("cell,class,num_views,num_right,share,share_low,share_high\n"),
                    HasSubstr("linear,all,16,")));
  for (const char* file : {"results.csv", "answers.csv"}) {
    EXPECT_EQ(ReadTextFile(folder / "one" / file), ReadTextFile(folder / "two" / file));
  }
}

TEST(RunViewStudy, LooksForDemonstrations) {
  const TemporaryDirectory folder;
  datasets::testing::WriteSmallSet(folder / "shown", {0.0, 30.0});
  const ViewStudy study{.name = "shown",
                        .title = "Shown",
                        .task = ViewTask::kNearestDemonstration,
                        .train = {.folder = (folder / "shown").string()},
                        .methods = {{"one", {}}}};
  const ViewStudyRun run = RunViewStudy(study, {.out = folder / "out"});
  EXPECT_EQ(run.results.front().groups.back().num_views, 12U);
  EXPECT_THAT(ReadTextFile(folder / "out/errors.csv"), HasSubstr("one,all,12,12,"));
  EXPECT_THAT(ReadTextFile(folder / "out/rejection.csv"),
              HasSubstr("cell,limit,num_kept,num_right\none,"));
  datasets::DemonstrationSet shown = datasets::ReadDemonstrationSet(folder / "shown");
  shown.items.pop_back();
  datasets::WriteDemonstrations(shown);
  EXPECT_THROWS_MESSAGE(static_cast<void>(RunViewStudy(study, {.out = folder / "out"})),
                        Error,
                        HasSubstr("data.demonstrations"));
}

// A study of made views from end to end: a turntable, poses shown on it, and the same objects
// moved.
TEST(RunViewStudy, TellsWhichGraspsWouldHold) {
  const TemporaryDirectory folder;
  handcraft::testing::MakeSmallViews(folder / "moved", 2, synthetic::ViewSetKind::kMoved);
  static_cast<void>(
      synthetic::MakeDemonstrations(folder / "shown",
                                    {.views = {.family = synthetic::Family::kRegrasp,
                                               .num_views = 4,
                                               .sensor = synthetic::CloudSensor::kPerfect,
                                               .camera = synthetic::testing::SmallCamera()},
                                     .poses_per_view = 20}));
  ViewStudy study{
      .name = "held",
      .title = "Held",
      .task = ViewTask::kGraspSuccess,
      .train = {.folder = (folder / "shown").string()},
      .test = ViewSource{.folder = (folder / "moved").string()},
      .demonstrations = ViewSource{.folder = (folder / "shown").string()},
      .groups = {{"bottles", {"water_bottle", "spray_bottle"}}},
      .settings = {{"grid_size", "8"},
                   {"click", "object"},
                   {"position", "demonstration"},
                   {"robot", HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/right_arm.toml"}},
      .methods = {{"class_told", {{"told_class", "yes"}}}}};
  const ViewStudyRun run = RunViewStudy(study, {.out = folder / "one"});
  const ViewCellResult& result = run.results.front();
  EXPECT_THAT(result.answers.rows,
              ::testing::ElementsAre("water_bottle", "spray_bottle", "coffee_can", "drill"));
  EXPECT_EQ(result.answers.columns.front(), "held");
  EXPECT_EQ(result.groups[4].name, "all");
  EXPECT_EQ(result.groups[4].num_views, 8U);
  EXPECT_GE(result.groups[4].num_right, 1U) << "some grasp holds";
  EXPECT_EQ(result.groups[5].name, "bottles");
  EXPECT_EQ(result.groups[5].num_views, 4U);
  EXPECT_EQ(result.groups[5].num_right, result.groups[0].num_right + result.groups[1].num_right);
  static_cast<void>(RunViewStudy(study, {.out = folder / "two", .num_threads = 2}));
  for (const char* file : {"results.csv", "answers.csv"}) {
    EXPECT_EQ(ReadTextFile(folder / "one" / file), ReadTextFile(folder / "two" / file));
  }
  study.groups["bottles"] = {"jug"};
  EXPECT_THROWS_MESSAGE(static_cast<void>(RunViewStudy(study, {.out = folder / "three"})),
                        Error,
                        HasSubstr("groups.bottles: \"jug\" is none of the objects"));
}

TEST(RunViewStudy, LooksForTheRobotBeforeItMakesSets) {
  const TemporaryDirectory folder;
  const ViewStudy study{.name = "plans",
                        .title = "Plans",
                        .task = ViewTask::kGraspPlan,
                        .train = {.families = {synthetic::Family::kTaught}, .num_views = 1},
                        .demonstrations = ViewSource{.folder = (folder / "no").string()},
                        .settings = {{"robot", (folder / "no.toml").string()}},
                        .methods = {{"click", {}}}};
  EXPECT_THROWS_MESSAGE(static_cast<void>(RunViewStudy(study, {.out = folder / "out"})),
                        Error,
                        HasSubstr("no.toml: cannot open"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/train"));
}

TEST(RunViewStudy, RefusesOtherInputsInTheSameFolder) {
  const TemporaryDirectory folder;
  ViewStudy study = MakeSmallViewStudy(folder / "views", ViewTask::kObjectRotation);
  static_cast<void>(RunViewStudy(study, {.out = folder / "out"}));
  study.settings.push_back({"candidates", "6"});
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(RunViewStudy(study, {.out = folder / "out"})), Error, HasSubstr("study"));
}

}  // namespace
}  // namespace handcraft::experiments
