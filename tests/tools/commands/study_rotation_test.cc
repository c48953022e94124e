// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/datasets/small_views.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

class StudyRotation : public ::testing::Test {
 protected:
  void SetUp() override {
    datasets::testing::WriteSmallSet(folder_.path(), {0.0, 10.0, 20.0, 30.0, 40.0});
  }

  handcraft::testing::TemporaryDirectory folder_;
};

TEST_F(StudyRotation, PrintsSharesAndHistogram) {
  const Outcome outcome = RunLine("study rotation --threads 1 " + folder_.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr("board"), HasSubstr("100.0 %"), HasSubstr("350: "), HasSubstr("all")));
}

TEST_F(StudyRotation, TellsMachinesMore) {
  const Outcome outcome =
      RunLine("study rotation --json --moments printed --candidates 6 " + folder_.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["classes"].size(), 2U);
  EXPECT_EQ(json["symmetries"][0]["num_views"], 10);
  EXPECT_EQ(json["symmetries"][0]["num_found"], 10);
  EXPECT_EQ(json["symmetries"][0]["histogram"].size(), 36U);
}

TEST_F(StudyRotation, RefusesWhatIsNoViewSet) {
  EXPECT_EQ(RunLine("study rotation /nowhere").code, 3);
}

}  // namespace
}  // namespace handcraft::tools
