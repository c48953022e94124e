// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/datasets/small_views.h"
#include "tests/experiments/view_studies/small_views.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;
using handcraft::testing::MakeSmallViewStudy;
using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(WriteViewStudyReport, TellsSharesAnswersAndVerdicts) {
  const TemporaryDirectory folder;
  for (const ViewTask task : {ViewTask::kObjectClass, ViewTask::kObjectRotation}) {
    const fs::path out = folder / std::string(NameOf(task));
    const ViewStudyRun run = RunViewStudy(MakeSmallViewStudy(folder / "views", task), {.out = out});
    static_cast<void>(WriteViewStudyReport(out, run));
    EXPECT_THAT(ReadTextFile(out / "report.html"),
                AllOf(HasSubstr("Study small"), HasSubstr("coffee_can"), HasSubstr("linear")));
    EXPECT_TRUE(fs::exists(out / "figures/right_answers.svg"));
    EXPECT_EQ(fs::exists(out / "figures/rotation_histogram_half_turn.svg"),
              task == ViewTask::kObjectRotation);
    const std::string summary = ReadTextFile(out / "summary.md");
    EXPECT_THAT(summary, HasSubstr("| right of [%] | nowhere | poly | linear |"));
    EXPECT_EQ(summary.find("nowhere has 100.00 %") != std::string::npos,
              task == ViewTask::kObjectClass);
  }
}

TEST(WriteViewStudyReport, PutsPublishedTimesBesideOurs) {
  const TemporaryDirectory folder;
  datasets::testing::WriteSmallSet(folder / "shown", {0.0, 30.0}, 0.0);
  const ViewStudy study{
      .name = "plans",
      .title = "Plans",
      .task = ViewTask::kGraspPlan,
      .train = {.folder = (folder / "shown").string()},
      .demonstrations = ViewSource{.folder = (folder / "shown").string()},
      .settings = {{"grid_size", "8"},
                   {"outlier_step", "0"},
                   {"robot", HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/right_arm.toml"}},
      .methods = {{"click", {}}},
      .claim_source = "Table 4.5",
      .claimed_ms = {{"object_class_ms", 103.0}, {"all_ms", 346.0}}};
  const fs::path out = folder / "out";
  static_cast<void>(WriteViewStudyReport(out, RunViewStudy(study, {.out = out})));
  EXPECT_THAT(ReadTextFile(out / "summary.md"),
              AllOf(HasSubstr("| Table 4.5 | – | 103 | – | – | – | 346 | – | – |"),
                    HasSubstr("## Outcomes\n\nclick:\n\n| object | nearest reached | next near"),
                    HasSubstr("| board | 2 | 0 | 0 | 0 | 0 | 0 | 100.0 [34")));
  EXPECT_TRUE(fs::exists(out / "figures/outcomes.svg"));
  EXPECT_THAT(ReadTextFile(out / "figures/layer_times.gnuplot"), HasSubstr("object_class_ms"));
  EXPECT_TRUE(fs::exists(out / "models/click/grasp_library.safetensors"));
}

TEST(WriteViewStudyReport, TellsErrorsOfDemonstrations) {
  const TemporaryDirectory folder;
  datasets::testing::WriteSmallSet(folder / "shown", {0.0, 30.0});
  const ViewStudy study{.name = "shown",
                        .title = "Shown",
                        .task = ViewTask::kNearestDemonstration,
                        .train = {.folder = (folder / "shown").string()},
                        .methods = {{"one", {}}},
                        .factors = {{"neighbours", {"1", "2"}}}};
  const fs::path out = folder / "out";
  static_cast<void>(WriteViewStudyReport(out, RunViewStudy(study, {.out = out})));
  for (const char* figure :
       {"position_error_by_neighbours", "rotation_error_by_neighbours", "rejection"}) {
    EXPECT_TRUE(fs::exists(out / "figures" / (std::string(figure) + ".svg"))) << figure;
  }
  EXPECT_THAT(ReadTextFile(out / "report.html"), HasSubstr("<h2>Errors</h2>"));
  EXPECT_THAT(ReadTextFile(out / "summary.md"), HasSubstr("| one,neighbours=2 | 12 of 12 |"));
}

}  // namespace
}  // namespace handcraft::experiments
