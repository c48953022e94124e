// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "experiments/runner/shipped_studies.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

TEST(StudyList, ShowsEveryShippedStudy) {
  const Outcome outcome = RunLine("study list");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  for (const experiments::ShippedStudy& study : experiments::ShippedStudies()) {
    EXPECT_THAT(outcome.out, HasSubstr(std::string(study.name)));
  }
  EXPECT_THAT(outcome.out, HasSubstr("feature-analysis"));
}

TEST(StudyList, ShowsThemToMachines) {
  const auto json = nlohmann::json::parse(RunLine("study list --json").out);
  ASSERT_EQ(json.size(), experiments::ShippedStudies().size());
  EXPECT_EQ(json[0]["name"], experiments::ShippedStudies()[0].name);
  EXPECT_GE(json[0]["num_cells_small"], 2);
}

}  // namespace
}  // namespace handcraft::tools
