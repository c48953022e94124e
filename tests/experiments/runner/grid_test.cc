// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/grid.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(MakeCells, CrossesMethodsFactorsAndRepetitions) {
  Study study = testing::SmallStudy("data");
  study.factors.push_back({"samples", {"10", "20", "30"}});
  const std::vector<Cell> cells = MakeCells(study);
  ASSERT_EQ(cells.size(), 2U * 2U * 3U * 2U);
  EXPECT_EQ(cells.front().id, "laplacian,ridge=0.5,samples=10,repetition=1");
  EXPECT_EQ(cells[1].id, "laplacian,ridge=0.5,samples=10,repetition=2");
  EXPECT_EQ(cells[2].id, "laplacian,ridge=0.5,samples=20,repetition=1");
  EXPECT_EQ(cells.back().id, "edge,ridge=2,samples=30,repetition=2");
  std::set<std::string> ids;
  for (const Cell& cell : cells) ids.insert(cell.id);
  EXPECT_EQ(ids.size(), cells.size());
}

TEST(MakeCells, KeepsTheIdsOfCellsWhenOthersAreAdded) {
  const Study study = testing::SmallStudy("data");
  Study longer = study;
  longer.methods.insert(longer.methods.begin(), {"new", {}});
  longer.factors[0].values.insert(longer.factors[0].values.begin(), "9");
  std::set<std::string> ids;
  for (const Cell& cell : MakeCells(longer)) ids.insert(cell.id);
  for (const Cell& cell : MakeCells(study)) EXPECT_EQ(ids.count(cell.id), 1U) << cell.id;
}

TEST(MakeCells, AppliesStudyThenMethodThenFactor) {
  Study study = testing::SmallStudy("data");
  study.settings.push_back({"ridge", "7"});
  study.methods[1].settings.push_back({"samples", "50"});
  const std::vector<Cell> cells = MakeCells(study);
  EXPECT_EQ(cells[0].settings.ridge, 0.5);
  EXPECT_EQ(cells[0].settings.samples, 200U);
  EXPECT_EQ(cells[4].settings.samples, 50U);
}

TEST(MakeCells, GivesEachRepetitionItsSeed) {
  Study study = testing::SmallStudy("data");
  study.seed = 40;
  const std::vector<Cell> cells = MakeCells(study);
  EXPECT_EQ(cells[0].seed, 40U);
  EXPECT_EQ(cells[1].seed, 41U);
}

TEST(MakeCells, NamesFilesThatAFileSystemTakes) {
  Study study = testing::SmallStudy("data");
  study.methods.resize(1);
  study.methods[0].settings.clear();
  study.factors = {{"features", {"all500,energy=log"}}};
  EXPECT_EQ(MakeCells(study)[0].id, "laplacian,features=all500+energy=log,repetition=1");
}

TEST(MakeCells, RefusesNamesThatNoFileSystemTakes) {
  Study study = testing::SmallStudy("data");
  study.methods[0].name = std::string(240, 'm');
  EXPECT_THROWS_MESSAGE(MakeCells(study), Error, HasSubstr("longer than the 230 bytes"));
}

TEST(MakeCells, RefusesToLeaveNothingToTestWith) {
  Study study = testing::SmallStudy("data");
  study.settings[1].value = "1";
  EXPECT_THROWS_MESSAGE(MakeCells(study),
                        Error,
                        AllOf(HasSubstr("cell laplacian,ridge=0.5,repetition=1"),
                              HasSubstr("no picture to test with")));
  study.test = DataSource{.folder = "other"};
  EXPECT_EQ(MakeCells(study).size(), 8U);
}

}  // namespace
}  // namespace handcraft::experiments
