// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

TEST(WriteStudyReport, WritesPageSummaryAndFigures) {
  const testing::TemporaryDirectory folder;
  testing::WriteRoughSet(folder / "data");
  const std::filesystem::path out = folder / "out";
  const StudyRun run = RunStudy(testing::SmallStudy(folder / "data"), {.out = out});
  const StudySummary summary = SummariseStudy(run, 1);
  const GnuplotReport report = WriteStudyReport(out, run, summary);
  EXPECT_THAT(ReadTextFile(out / "summary.md"), HasSubstr("# Rough <or> smooth"));
  EXPECT_THAT(ReadTextFile(out / "report.html"), HasSubstr("data:image/jpeg;base64,"));
  EXPECT_THAT(ReadTextFile(out / "figures/best_pixel_accuracy.svg"), HasSubstr("<svg"));
  EXPECT_EQ(std::filesystem::exists(out / "figures/difference_to_baseline.pdf"),
            report.has_gnuplot);
  const std::string page = ReadTextFile(out / "report.html");
  static_cast<void>(WriteStudyReport(out, run, summary));
  EXPECT_EQ(ReadTextFile(out / "report.html"), page);
}

}  // namespace
}  // namespace handcraft::experiments
