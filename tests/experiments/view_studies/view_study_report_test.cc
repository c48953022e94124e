// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
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
    EXPECT_EQ(fs::exists(out / "figures/rotation_histogram.svg"),
              task == ViewTask::kObjectRotation);
    const std::string summary = ReadTextFile(out / "summary.md");
    EXPECT_THAT(summary, HasSubstr("| right of | poly | linear |"));
    EXPECT_EQ(summary.find("nowhere has 100.00 %") != std::string::npos,
              task == ViewTask::kObjectClass);
  }
}

}  // namespace
}  // namespace handcraft::experiments
