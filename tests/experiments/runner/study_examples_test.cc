// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_examples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

class MakeExamplesTest : public ::testing::Test {
 protected:
  MakeExamplesTest() { testing::WriteRoughSet(folder_ / "data"); }

  testing::TemporaryDirectory folder_;
};

TEST_F(MakeExamplesTest, ShowsEverySeriesOnPicturesThatAllWereTestedWith) {
  const StudyRun run = RunStudy(testing::SmallStudy(folder_ / "data"), {.out = folder_ / "out"});
  const StudySummary summary = SummariseStudy(run, 1);
  const std::vector<Example> examples = MakeExamples(run, summary, folder_ / "out", 3);
  ASSERT_EQ(examples.size(), 3U);
  for (const Example& example : examples) {
    ASSERT_EQ(example.overlays.size(), 4U);
    EXPECT_EQ(example.overlays[0].label, "laplacian, ridge = 0.5");
    EXPECT_EQ(example.labels_jpeg[0], 0xFF);  // begins as JPEG files do
    EXPECT_EQ(example.overlays[3].jpeg[0], 0xFF);
  }
  EXPECT_NE(examples[0].image, examples[1].image);
  EXPECT_EQ(MakeExamples(run, summary, folder_ / "out", 50).size(), 4U);
}

TEST_F(MakeExamplesTest, NamesTheModelThatIsMissing) {
  const StudyRun run = RunStudy(testing::SmallStudy(folder_ / "data"), {.out = folder_ / "out"});
  std::filesystem::remove(ModelFileOf(folder_ / "out", run.cells[0]));
  EXPECT_THROWS_MESSAGE(MakeExamples(run, SummariseStudy(run, 1), folder_ / "out", 1),
                        Error,
                        ::testing::HasSubstr("laplacian,ridge=0.5,repetition=1.safetensors"));
}

}  // namespace
}  // namespace handcraft::experiments
