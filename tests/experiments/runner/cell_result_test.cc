// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/cell_result.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/experiments/evaluation/edge_model.h"
#include "tests/experiments/runner/small_result.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

TEST(MakeCellResult, SumsUpEachPicture) {
  const testing::TemporaryDirectory folder;
  const datasets::LabelledImageSet set = testing::WriteEdgeSet(folder.path());
  const testing::ModelOwner model = testing::MakeEdgeModel();
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model.get(), set, {});
  const CellResult result = MakeCellResult("cell", {.num_samples = 5}, evaluation, set);
  EXPECT_EQ(result.num_samples, 5U);
  ASSERT_EQ(result.groups.size(), 3U);
  EXPECT_EQ(result.groups[0].name, "edge");
  EXPECT_EQ(result.groups[2].name, "all");
  ASSERT_EQ(result.images.size(), 5U);
  EXPECT_EQ(result.images[1].image, "half.png");
  EXPECT_EQ(result.images[1].best.good, 7U);
  EXPECT_EQ(result.images[1].best.bad, 8U);
  // The sums give the figures of all pictures again.
  double log_loss_sum = 0.0;
  double squared_error_sum = 0.0;
  ConfusionMatrix confusion;
  std::size_t num_pixels = 0;
  for (const ImageFigures& image : result.images) {
    log_loss_sum += image.log_loss_sum;
    squared_error_sum += image.squared_error_sum;
    confusion += image.confusion;
    num_pixels += image.num_pixels;
  }
  const auto count = static_cast<double>(num_pixels);
  EXPECT_DOUBLE_EQ(confusion.Accuracy(), evaluation.all.accuracy.value);
  EXPECT_NEAR(log_loss_sum / count, evaluation.all.log_loss.value, 1e-12);
  EXPECT_NEAR(squared_error_sum / count, evaluation.all.brier.value, 1e-12);
}

TEST(MakeCellResult, KeepsCurvesWithTheirEndsInFewPoints) {
  const testing::TemporaryDirectory folder;
  const datasets::LabelledImageSet set = testing::WriteEdgeSet(folder.path());
  const testing::ModelOwner model = testing::MakeEdgeModel();
  GraspPointEvaluation evaluation = EvaluateGraspPoints(model.get(), set, {});
  const PixelCurves curves = MakeCellResult("cell", {}, evaluation, set).curves;
  EXPECT_EQ(curves.roc.size(), evaluation.curves.roc.size());
  std::size_t num_pixels = 0;
  for (const ReliabilityBin& entry : curves.reliability) num_pixels += entry.bin.Total();
  EXPECT_EQ(num_pixels, evaluation.all.confusion.Total());
  evaluation.curves.roc.clear();
  for (int i = 0; i <= 200; ++i) evaluation.curves.roc.push_back({i / 200.0, i / 200.0});
  const std::vector<RocPoint> thinned = MakeCellResult("cell", {}, evaluation, set).curves.roc;
  ASSERT_EQ(thinned.size(), 101U);
  EXPECT_EQ(thinned.front().true_positive_rate, 0.0);
  EXPECT_EQ(thinned[50].true_positive_rate, 0.5);
  EXPECT_EQ(thinned.back().true_positive_rate, 1.0);
}

TEST(ReadCellResult, GivesBackWhatWasWritten) {
  const testing::TemporaryDirectory folder;
  const CellResult written = testing::SmallResult("a,ridge=0.1");
  WriteCellResult(folder / "cell.json", written);
  const CellResult read = ReadCellResult(folder / "cell.json", "a,ridge=0.1");
  EXPECT_EQ(read.termination, "converged");
  EXPECT_EQ(read.training_log_loss, 0.1);
  EXPECT_EQ(read.training_time_s, 0.5);
  ASSERT_EQ(read.groups.size(), 2U);
  EXPECT_EQ(read.groups[0].name, "mug, blue");
  EXPECT_EQ(read.groups[0].best_pixel_accuracy.value, 2.0 / 3.0);
  EXPECT_TRUE(std::isnan(read.groups[0].auc.low));
  ASSERT_EQ(read.images.size(), 2U);
  EXPECT_EQ(read.images[0].best.good, 12U);
  EXPECT_EQ(read.images[0].confusion.true_negative, 5U);
  EXPECT_EQ(read.images[0].log_loss_sum, 1.0 / 3.0);
  ASSERT_EQ(read.curves.roc.size(), 3U);
  EXPECT_EQ(read.curves.roc[1].false_positive_rate, 1.0 / 3.0);
  EXPECT_EQ(read.curves.precision_recall[0].precision, 0.75);
  EXPECT_EQ(read.curves.reliability[0].bin.num_bad, 3U);
  EXPECT_EQ(read.curves.reliability[0].good_share.low, 0.1);
  EXPECT_TRUE(std::isnan(read.curves.reliability[1].bin.mean_probability));
  ASSERT_EQ(read.curves.bands.roc.size(), 2U);
  EXPECT_TRUE(std::isnan(read.curves.bands.roc[0].low));
  EXPECT_EQ(read.curves.bands.precision_recall[0].low, 1.0 / 3.0);
  EXPECT_EQ(read.search_space.num_images_without_region, 1U);
  ASSERT_EQ(read.search_space.stages.size(), 2U);
  EXPECT_EQ(read.search_space.stages[1].stage, "region");
  EXPECT_EQ(read.search_space.stages[1].num_pixels, 12.5);
  WriteCellResult(folder / "again.json", read);
  EXPECT_EQ(ReadTextFile(folder / "again.json"), ReadTextFile(folder / "cell.json"));
}

TEST(ReadCellResult, RefusesOtherAndDamagedFiles) {
  const testing::TemporaryDirectory folder;
  WriteCellResult(folder / "cell.json", testing::SmallResult("a"));
  EXPECT_THROWS_MESSAGE(
      ReadCellResult(folder / "cell.json", "b"), Error, HasSubstr("holds the cell a, not b"));
  const std::string text = ReadTextFile(folder / "cell.json");
  for (const std::string& damaged :
       {std::string(), text.substr(0, text.size() / 2), std::string("[]"), std::string("{}")}) {
    WriteFileAtomically(folder / "cell.json", damaged);
    EXPECT_THROWS_MESSAGE(ReadCellResult(folder / "cell.json", "a"),
                          Error,
                          AllOf(HasSubstr("cell.json"), HasSubstr("is no result of a cell")));
  }
}

TEST(ReadCellResult, DoesNotBelieveAChangedNumber) {
  const testing::TemporaryDirectory folder;
  WriteCellResult(folder / "cell.json", testing::SmallResult("a"));
  std::string text = ReadTextFile(folder / "cell.json");
  const std::string number = "\"best_good\": 20";
  const std::size_t at = text.find(number);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, number.size(), "\"best_good\": 29");
  WriteFileAtomically(folder / "cell.json", text);
  EXPECT_THROWS_MESSAGE(ReadCellResult(folder / "cell.json", "a"),
                        Error,
                        AllOf(HasSubstr("cell.json"), HasSubstr("has been changed")));
}

TEST(ReadCellResult, RefusesOneWithoutFigures) {
  const testing::TemporaryDirectory folder;
  CellResult result = testing::SmallResult("a");
  result.groups.clear();
  WriteCellResult(folder / "cell.json", result);
  EXPECT_THROWS_MESSAGE(
      ReadCellResult(folder / "cell.json", "a"), Error, HasSubstr("has no figures"));
}

}  // namespace
}  // namespace handcraft::experiments
