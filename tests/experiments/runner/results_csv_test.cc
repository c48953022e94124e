// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/results_csv.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/formats/csv_rows.h"
#include "lib/core/file.h"
#include "tests/experiments/runner/small_result.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(ResultsCsv, HasARowForEachCellAndClass) {
  const std::vector<Cell> cells = MakeCells(testing::SmallStudy("data"));
  std::vector<CellResult> results;
  results.reserve(cells.size());
  for (const Cell& cell : cells) results.push_back(testing::SmallResult(cell.id));
  const testing::TemporaryDirectory folder;
  const std::string text = ResultsCsv(cells, results);
  EXPECT_THAT(text, StartsWith("cell,method,ridge,repetition,class,termination,"));
  EXPECT_THAT(text, Not(HasSubstr("time")));
  WriteFileAtomically(folder / "r.csv", text);
  constexpr std::array<std::string_view, 7> kColumns = {
      "cell", "method", "ridge", "class", "best_pixel_accuracy", "auc", "num_samples"};
  datasets::CsvRows rows(folder / "r.csv", kColumns);
  for (const Cell& cell : cells) {
    for (const std::string_view object_class : {"mug, blue", "all"}) {
      ASSERT_TRUE(rows.Next());
      EXPECT_EQ(rows.Text(0), cell.id);
      EXPECT_EQ(rows.Text(1), cell.method);
      EXPECT_EQ(rows.Text(2), cell.factors[0].value);
      EXPECT_EQ(rows.Text(3), object_class);
      EXPECT_EQ(rows.Number(4), 2.0 / 3.0);
      EXPECT_EQ(rows.Text(5), "");
      EXPECT_EQ(rows.Number(6), 200.0);
    }
  }
  EXPECT_FALSE(rows.Next());
}

TEST(ResultsCsv, RefusesOtherNumbersOfResults) {
  const std::vector<Cell> cells = MakeCells(testing::SmallStudy("data"));
  EXPECT_THROW(static_cast<void>(ResultsCsv(cells, {})), std::logic_error);
}

TEST(SearchSpaceCsv, HasARowAStage) {
  CellResult without = testing::SmallResult("none");
  without.search_space = {};
  const std::vector<CellResult> results = {testing::SmallResult("b,c"), without};
  EXPECT_EQ(SearchSpaceCsv(results),
            "cell,num_images_without_region,stage,num_pixels,time_ms\n"
            "\"b,c\",1,picture,300,0\n\"b,c\",1,region,12.5,0.75\n");
}

TEST(TimesCsv, HasARowACell) {
  const std::vector<CellResult> results = {testing::SmallResult("a"), testing::SmallResult("b,c")};
  EXPECT_EQ(TimesCsv(results),
            "cell,features_time_s,training_time_s,score_time_ms\n"
            "a,0.25,0.5,7\n\"b,c\",0.25,0.5,7\n");
}

}  // namespace
}  // namespace handcraft::experiments
