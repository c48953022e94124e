// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

class StudyCompareTest : public ::testing::Test {
 protected:
  void Write(const std::string& run, const std::string& csv) const {
    std::filesystem::create_directory(folder_ / run);
    WriteFileAtomically(folder_ / run / "results.csv", csv);
  }
  [[nodiscard]] Outcome Compare(const std::string& more) const {
    return RunLine("study compare " + (folder_ / "a").string() + " " + (folder_ / "b").string() +
                   more);
  }

  handcraft::testing::TemporaryDirectory folder_;
};

TEST_F(StudyCompareTest, SaysThatRunsAreTheSame) {
  Write("a", "cell,class,auc\nx,all,1\n");
  Write("b", "cell,class,auc\nx,all,1\n");
  const Outcome outcome = Compare("");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("the same: 1 rows"));
}

TEST_F(StudyCompareTest, ShowsWhereRunsDifferAndFails) {
  Write("a", "cell,class,auc\nx,all,1\n");
  Write("b", "cell,class,auc\nx,all,0.5\n");
  const Outcome outcome = Compare("");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.out, HasSubstr("auc"));
  EXPECT_THAT(outcome.err, HasSubstr("the two runs differ"));
  const auto json = nlohmann::json::parse(Compare(" --json").out);
  EXPECT_EQ(json["same"], false);
  EXPECT_EQ(json["differences"][0]["second"], "0.5");
}

TEST_F(StudyCompareTest, NamesAFolderWithoutResults) {
  Write("a", "cell,class,auc\n");
  const Outcome outcome = Compare("");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("holds no results.csv"));
}

}  // namespace
}  // namespace handcraft::tools
