// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view kWhole = R"(name = "mine"
title = "Mine"
question = "Which?"
task = "object-class"
[data.train]
made = ["taught", "untaught"]
views = { small = 4, full = 36 }
sets = 2
seed = 5
sensor = "perfect"
[data.test]
folder = "views"
[association]
box = ["can", "drill"]
cup = "mug"
[settings]
kernel = "poly"
[[method]]
name = "metric"
[[method]]
name = "unit"
scaling = "unit"
[grid]
C = [1, 10]
[claim]
source = "Table 4.2"
all = 97.69
)";

std::string Minimal(const std::string& data, const std::string& rest = "") {
  return "name = \"m\"\ntitle = \"M\"\ntask = \"object-class\"\n[data.train]\n" + data + "\n" +
         rest + "\n[[method]]\nname = \"a\"\n";
}

ViewStudy Parse(const std::string& text) {
  return ParseViewStudy(text, "s.toml", StudySize::kSmall);
}

TEST(ViewStudy, IsReadWhole) {
  const ViewStudy study = Parse(std::string(kWhole));
  EXPECT_EQ(study.task, ViewTask::kObjectClass);
  EXPECT_THAT(study.train.families,
              ElementsAre(synthetic::Family::kTaught, synthetic::Family::kUntaught));
  EXPECT_EQ(study.train.num_views, 4);
  EXPECT_EQ(study.train.num_sets, 2);
  EXPECT_EQ(study.train.seed, 5U);
  EXPECT_EQ(study.train.sensor, synthetic::CloudSensor::kPerfect);
  ASSERT_TRUE(study.test);
  EXPECT_EQ(study.test->folder, "views");
  EXPECT_THAT(study.associations.at("box"), ElementsAre("can", "drill"));
  EXPECT_THAT(study.associations.at("cup"), ElementsAre("mug"));
  EXPECT_EQ(study.claims.at("all"), 97.69);
  EXPECT_EQ(ParseViewStudy(kWhole, "s", StudySize::kFull).train.num_views, 36);
}

TEST(ViewStudy, CellsAreMethodsTimesFactors) {
  const std::vector<ViewCell> cells = MakeViewCells(Parse(std::string(kWhole)));
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[3].id, "unit,C=10");
  EXPECT_EQ(cells[3].settings.classes.svm.penalty, 10.0);
  EXPECT_EQ(cells[3].settings.classes.descriptor.scaling, features::CloudScaling::kUnit);
  EXPECT_EQ(cells[0].settings.classes.descriptor.scaling, features::CloudScaling::kMetric);
}

TEST(ViewStudy, MayAskAboutDemonstrations) {
  std::string text = Minimal("made = \"taught\"\nviews = 3\nposes = { small = 5, full = 40 }");
  text.replace(text.find("object-class"), 12, "nearest-demonstration");
  const ViewStudy study = Parse(text);
  EXPECT_EQ(study.task, ViewTask::kNearestDemonstration);
  EXPECT_EQ(study.train.num_poses, 5);
  EXPECT_THAT(CanonicalLines(study), ::testing::Contains(HasSubstr("3 views, 5 poses each")));
  text.replace(text.find("[[method]]"), 0, "[data.test]\nfolder = \"f\"\n");
  EXPECT_THROWS_MESSAGE(static_cast<void>(Parse(text)),
                        Error,
                        HasSubstr("nearest-demonstration asks about [data.train]"));
  text = Minimal("folder = \"f\"\nsplit = \"train\"");
  text.replace(text.find("object-class"), 12, "nearest-demonstration");
  EXPECT_THROWS_MESSAGE(static_cast<void>(Parse(text)),
                        Error,
                        HasSubstr("nearest-demonstration asks about all of a folder"));
}

TEST(ViewStudy, MayAskForPlans) {
  std::string text = Minimal("folder = \"f\"",
                             "[data.demonstrations]\nmade = \"taught\"\nviews = 12\nposes = 40\n"
                             "[claim]\nsource = \"Table 4.5\"\n[claim.times]\nall_ms = 346\n");
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(Parse(text)), Error, HasSubstr("tasks grasp-plan and grasp-s"));
  text.replace(text.find("object-class"), 12, "grasp-plan");
  const ViewStudy study = Parse(text);
  EXPECT_EQ(study.task, ViewTask::kGraspPlan);
  ASSERT_TRUE(study.demonstrations);
  EXPECT_EQ(study.demonstrations->num_poses, 40);
  EXPECT_EQ(study.claimed_ms.at("all_ms"), 346.0);
  EXPECT_THAT(CanonicalLines(study), ::testing::Contains(HasSubstr("data.demonstrations = turn")));
  text.replace(text.find("poses = 40"), 10, "seed = 4");
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(Parse(text)), Error, HasSubstr("made demonstrations need poses"));
}

TEST(ViewStudy, MayAskWhetherPlansHoldOtherViews) {
  std::string text = Minimal("made = \"taught\"\nviews = 2",
                             "[data.demonstrations]\nmade = \"taught\"\nviews = 2\nposes = 4\n"
                             "[data.test]\nmade = \"untaught\"\nkind = \"moved\"\nviews = 2\n"
                             "[groups]\nboxes = [\"dvd_case\", \"rectangular_box\"]\n");
  text.replace(text.find("object-class"), 12, "grasp-success");
  const ViewStudy study = Parse(text);
  EXPECT_EQ(study.task, ViewTask::kGraspSuccess);
  ASSERT_TRUE(study.test);
  EXPECT_THAT(study.groups.at("boxes"), ElementsAre("dvd_case", "rectangular_box"));
  EXPECT_THAT(CanonicalLines(study),
              ::testing::Contains("groups.boxes = dvd_case, rectangular_box"));
}

TEST(RightClasses, AreThoseAssociatedOrTheClassItself) {
  const ViewStudy study = Parse(std::string(kWhole));
  EXPECT_THAT(RightClasses(study, "box"), ElementsAre("can", "drill"));
  EXPECT_THAT(RightClasses(study, "drill"), ElementsAre("drill"));
}

TEST(ViewStudy, EverythingThatChangesAResultIsInItsLines) {
  const std::vector<std::string> whole = CanonicalLines(Parse(std::string(kWhole)));
  for (const auto& [from, to] : {std::pair{"seed = 5", "seed = 6"},
                                 std::pair{"sets = 2", "sets = 3"},
                                 std::pair{"perfect", "stereo"},
                                 std::pair{"small = 4", "small = 5"},
                                 std::pair{"[1, 10]", "[1, 11]"},
                                 std::pair{"scaling = \"unit\"", "scaling = \"metric\""},
                                 std::pair{"cup = \"mug\"", "cup = \"can\""},
                                 std::pair{"\"views\"", "\"other\""}}) {
    std::string text(kWhole);
    text.replace(text.find(from), std::string(from).size(), to);
    EXPECT_NE(CanonicalLines(Parse(text)), whole) << to;
  }
}

TEST(ViewStudy, IsToldFromStudiesOfPixelsByItsTask) {
  EXPECT_TRUE(IsViewStudy(kWhole, "s"));
  EXPECT_FALSE(IsViewStudy("name = \"pixels\"", "s"));
}

TEST(ViewStudy, RefusesWhatDoesNotFitWithItsLine) {
  const std::pair<std::string, const char*> cases[] = {
      {Minimal("made = \"trained\"\nviews = 3"), "s.toml:5: made is \"trained\""},
      {Minimal("made = \"taught\""), "views"},
      {Minimal("made = \"taught\"\nviews = 1"), "views must be a whole number from 2"},
      {Minimal("made = \"taught\"\nfolder = \"f\""), "either a folder or made views"},
      {Minimal("folder = \"f\"\nviews = 3"), "views"},
      {Minimal("made = \"taught\"\nviews = 3\nsplit = \"test\""),
       "split is of the views of a folder"},
      {Minimal("made = []\nviews = 3"), "made is an empty list"},
      {Minimal("made = \"taught\"\nviews = 3\nkind = \"still\""), "kind is \"still\""},
      {Minimal("made = \"taught\"\nviews = 3\nsensor = \"nose\""), "sensor is \"nose\""},
      {Minimal("made = \"taught\"\nviews = 3\nsets = 2\nposes = 4"), "the turntable of one family"},
      {Minimal("folder = \"f\"", "[settings]\nkernel = \"cubic\""), "kernel is \"cubic\""},
      {Minimal("folder = \"f\"", "[claim]\nall = 101"), "all must be a number from 0 to 100"},
      {Minimal("folder = \"f\"", "[association]\nbox = [1]"), "box holds something else"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_THROWS_MESSAGE(static_cast<void>(Parse(text)), Error, HasSubstr(message));
  }
  std::string task = Minimal("folder = \"f\"");
  task.replace(task.find("object-class"), 12, "object-shape");
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(Parse(task)), Error, HasSubstr("s.toml:3: task is \"object-shape\""));
}

}  // namespace
}  // namespace handcraft::experiments
