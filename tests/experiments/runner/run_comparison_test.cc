// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/run_comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class CompareRunsTest : public ::testing::Test {
 protected:
  void Write(const std::string& run, const std::string& csv, const std::string& study) const {
    std::filesystem::create_directories(folder_ / run / "inputs");
    WriteFileAtomically(folder_ / run / "results.csv", csv);
    WriteFileAtomically(folder_ / run / "inputs/study", study);
  }
  [[nodiscard]] RunComparison Compare() const { return CompareRuns(folder_ / "a", folder_ / "b"); }

  testing::TemporaryDirectory folder_;
};

TEST_F(CompareRunsTest, FindsEqualRunsEqual) {
  Write("a", "cell,class,auc\nx,all,0.5\n", "s");
  Write("b", "cell,class,auc\nx,all,0.5\n", "s");
  EXPECT_TRUE(Compare().IsSame());
  EXPECT_EQ(Compare().num_rows, 1U);
}

TEST_F(CompareRunsTest, NamesCellClassAndColumn) {
  Write("a", "cell,class,auc,brier\nx,mug,0.5,1\n\"y,1\",all,0.25,2\n", "s");
  Write("b", "cell,class,auc,brier\nx,mug,0.5,1\n\"y,1\",all,0.26,2\n", "s");
  const RunComparison comparison = Compare();
  ASSERT_EQ(comparison.differences.size(), 1U);
  EXPECT_EQ(comparison.differences[0].cell, "y,1");
  EXPECT_EQ(comparison.differences[0].object_class, "all");
  EXPECT_EQ(comparison.differences[0].column, "auc");
  EXPECT_EQ(comparison.differences[0].first, "0.25");
  EXPECT_EQ(comparison.differences[0].second, "0.26");
}

TEST_F(CompareRunsTest, FindsRowsColumnsAndInputsOfOneSide) {
  Write("a", "cell,class,auc\nx,all,1\ny,all,1\n", "s");
  Write("b", "class,cell,brier\nall,x,2\nall,z,2\n", "t");
  const RunComparison comparison = Compare();
  EXPECT_THAT(comparison.inputs, ElementsAre("study"));
  EXPECT_EQ(comparison.num_rows, 1U);
  ASSERT_EQ(comparison.differences.size(), 4U);
  EXPECT_EQ(comparison.differences[0].second, "missing");  // auc of x
  EXPECT_EQ(comparison.differences[1].first, "missing");   // brier of x
  EXPECT_EQ(comparison.differences[2].cell, "y");
  EXPECT_EQ(comparison.differences[3].cell, "z");
}

TEST_F(CompareRunsTest, RefusesWhatIsNoRun) {
  Write("a", "cell,class\nx,all\n", "s");
  EXPECT_THROWS_MESSAGE(Compare(), Error, HasSubstr("holds no results.csv"));
  Write("b", "", "s");
  EXPECT_THROWS_MESSAGE(Compare(), Error, HasSubstr("no columns cell and class"));
  Write("b", "cell,class\nx\n", "s");
  EXPECT_THROWS_MESSAGE(Compare(), Error, HasSubstr("another number of fields"));
}

}  // namespace
}  // namespace handcraft::experiments
