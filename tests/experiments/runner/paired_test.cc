// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/paired.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/experiments/evaluation/edge_model.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using Cells = std::array<const CellResult*, 1>;

ImageFigures Picture(const std::string& name,
                     const std::string& object_class,
                     std::size_t good,
                     std::size_t bad) {
  return {.image = name,
          .object_class = object_class,
          .best = {.good = good, .bad = bad},
          .num_pixels = 10,
          .confusion = {.true_positive = good, .true_negative = 0, .false_negative = 10 - good},
          .log_loss_sum = static_cast<double>(bad),
          .squared_error_sum = 0.5 * static_cast<double>(bad)};
}

// Thirty pictures; `ours` finds two best pixels more than `baseline` on each of them.
struct TwoCells {
  CellResult ours;
  CellResult baseline;
};
TwoCells RandomCells() {
  TwoCells cells;
  Rng rng(3);
  for (int i = 0; i < 30; ++i) {
    const std::string name = "p" + std::to_string(i);
    const std::string object_class = i < 10 ? "mug" : "pen";
    const std::size_t good = rng.UniformInt(7);
    cells.ours.images.push_back(Picture(name, object_class, good + 2, 8 - good));
    cells.baseline.images.push_back(Picture(name, object_class, good, 10 - good));
  }
  return cells;
}

TEST(PoolFigures, CountsByHand) {
  CellResult cell;
  cell.images = {Picture("a", "mug", 6, 4), Picture("b", "pen", 0, 5)};
  const PooledFigures all = PoolFigures(Cells{&cell}, "", {});
  EXPECT_EQ(all.num_images, 2U);
  EXPECT_DOUBLE_EQ(all.best_pixel_accuracy.value, 6.0 / 15.0);
  EXPECT_DOUBLE_EQ(all.accuracy.value, 6.0 / 20.0);
  EXPECT_DOUBLE_EQ(all.log_loss.value, 9.0 / 20.0);
  EXPECT_DOUBLE_EQ(all.brier.value, 4.5 / 20.0);
  EXPECT_DOUBLE_EQ(PoolFigures(Cells{&cell}, "mug", {}).best_pixel_accuracy.value, 0.6);
  EXPECT_EQ(PoolFigures(Cells{&cell}, "hat", {}).num_images, 0U);
  EXPECT_TRUE(std::isnan(PoolFigures(Cells{&cell}, "hat", {}).accuracy.value));
}

TEST(PoolFigures, IsNotCertainOfAShareOfZero) {
  CellResult cell;
  cell.images = {Picture("a", "mug", 0, 4), Picture("b", "mug", 0, 5), Picture("c", "mug", 0, 0)};
  const Estimate accuracy = PoolFigures(Cells{&cell}, "", {}).best_pixel_accuracy;
  EXPECT_EQ(accuracy.value, 0.0);
  EXPECT_EQ(accuracy.high, WilsonInterval(0, 2).high);
}

TEST(PoolFigures, HasNoIntervalOfTheOnlyPictureThatCounts) {
  CellResult cell;
  cell.images = {Picture("a", "mug", 2, 4), Picture("b", "mug", 0, 0)};
  EXPECT_TRUE(std::isnan(PoolFigures(Cells{&cell}, "", {}).best_pixel_accuracy.low));
}

// results.csv and summary.md tell the same of the same pictures.
TEST(PoolFigures, HasTheIntervalsOfTheCellItself) {
  const testing::TemporaryDirectory folder;
  const datasets::LabelledImageSet set = testing::WriteEdgeSet(folder.path());
  const testing::ModelOwner model = testing::MakeEdgeModel();
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(
      model.get(), set, {.bootstrap_resamples = 200, .seed = 3, .num_threads = 2});
  const CellResult cell = MakeCellResult("cell", {}, evaluation, set);
  const auto expect_equal = [](const Estimate& pooled, const Estimate& own, const char* what) {
    EXPECT_EQ(pooled.value, own.value) << what;
    EXPECT_TRUE(pooled.low == own.low || (std::isnan(pooled.low) && std::isnan(own.low))) << what;
    EXPECT_TRUE(pooled.high == own.high || (std::isnan(pooled.high) && std::isnan(own.high)))
        << what;
  };
  ASSERT_EQ(cell.groups.size(), 3U);
  for (const GroupFigures& own : cell.groups) {
    const PooledFigures pooled =
        PoolFigures(Cells{&cell}, own.name == "all" ? "" : own.name, {.resamples = 200, .seed = 3});
    EXPECT_EQ(pooled.num_images, own.num_images);
    expect_equal(pooled.best_pixel_accuracy, own.best_pixel_accuracy, "best pixels");
    expect_equal(pooled.accuracy, own.accuracy, "accuracy");
    expect_equal(pooled.log_loss, own.log_loss, "log-loss");
    expect_equal(pooled.brier, own.brier, "Brier score");
  }
  EXPECT_FALSE(std::isnan(cell.groups.back().accuracy.low));
}

TEST(PoolFigures, TakesAPicturesRepetitionsTogether) {
  CellResult first;
  first.images = {Picture("a", "mug", 1, 1)};
  CellResult second;
  second.images = {Picture("a", "mug", 3, 1), Picture("b", "mug", 2, 2)};
  const std::array<const CellResult*, 2> both = {&first, &second};
  const PooledFigures figures = PoolFigures(both, "", {});
  EXPECT_EQ(figures.num_images, 2U);
  EXPECT_DOUBLE_EQ(figures.best_pixel_accuracy.value, 6.0 / 10.0);
}

TEST(CompareFigures, KnowsADifferenceThatEveryPictureAgreesOn) {
  const TwoCells cells = RandomCells();
  const Difference figures = CompareFigures(Cells{&cells.ours}, Cells{&cells.baseline}, "", {});
  // Two more of ten best pixels on every picture: nothing varies, whatever the pictures are like.
  EXPECT_NEAR(figures.best_pixel_accuracy.value, 0.2, 1e-12);
  EXPECT_NEAR(figures.best_pixel_accuracy.low, 0.2, 1e-12);
  EXPECT_NEAR(figures.best_pixel_accuracy.high, 0.2, 1e-12);
  const PooledFigures alone = PoolFigures(Cells{&cells.ours}, "", {});
  EXPECT_GT(alone.best_pixel_accuracy.high - alone.best_pixel_accuracy.low, 0.05);
}

TEST(CompareFigures, IsTheDifferenceOfTheFiguresAndChangesSignWithTheSides) {
  const TwoCells cells = RandomCells();
  const Cells ours = {&cells.ours};
  const Cells baseline = {&cells.baseline};
  for (const std::string object_class : {"", "mug"}) {
    const Difference difference = CompareFigures(ours, baseline, object_class, {});
    const Difference turned = CompareFigures(baseline, ours, object_class, {});
    EXPECT_NEAR(difference.log_loss.value,
                PoolFigures(ours, object_class, {}).log_loss.value -
                    PoolFigures(baseline, object_class, {}).log_loss.value,
                1e-12);
    EXPECT_NEAR(difference.log_loss.low, -turned.log_loss.high, 1e-12);
  }
}

TEST(CompareFigures, FindsNoDifferenceBetweenACellAndItself) {
  const TwoCells cells = RandomCells();
  const Difference figures = CompareFigures(Cells{&cells.ours}, Cells{&cells.ours}, "", {});
  EXPECT_EQ(figures.brier.value, 0.0);
  EXPECT_EQ(figures.brier.low, 0.0);
  EXPECT_EQ(figures.brier.high, 0.0);
}

TEST(CompareFigures, TellsPicturesOnWhichOneFindsNothingApart) {
  CellResult ours;
  ours.images = {Picture("a", "mug", 5, 5), Picture("b", "mug", 9, 1), Picture("c", "mug", 0, 0)};
  CellResult baseline;
  baseline.images = {
      Picture("a", "mug", 4, 6), Picture("b", "mug", 8, 2), Picture("c", "mug", 0, 9)};
  const Difference figures = CompareFigures(Cells{&ours}, Cells{&baseline}, "", {});
  EXPECT_EQ(figures.num_images, 3U);
  EXPECT_NEAR(figures.best_pixel_accuracy.value, 14.0 / 20.0 - 12.0 / 29.0, 1e-12);
  EXPECT_EQ(figures.num_images_with_both, 2U);
  EXPECT_NEAR(figures.best_pixel_accuracy_with_both.value, 0.1, 1e-12);
}

TEST(CompareFigures, LooksAtPicturesThatBothHaveAlone) {
  CellResult ours;
  ours.images = {Picture("a", "mug", 5, 5), Picture("b", "mug", 9, 1)};
  CellResult baseline;
  baseline.images = {Picture("c", "mug", 0, 9), Picture("a", "mug", 4, 6)};
  const Difference figures = CompareFigures(Cells{&ours}, Cells{&baseline}, "", {});
  EXPECT_EQ(figures.num_images, 1U);
  EXPECT_NEAR(figures.best_pixel_accuracy.value, 0.1, 1e-12);
  EXPECT_TRUE(std::isnan(figures.best_pixel_accuracy.low));  // one picture tells of no spread
}

TEST(CompareFigures, GivesTheSameForAnyNumberOfThreads) {
  const TwoCells cells = RandomCells();
  const Difference one =
      CompareFigures(Cells{&cells.ours}, Cells{&cells.baseline}, "mug", {.num_threads = 1});
  const Difference three =
      CompareFigures(Cells{&cells.ours}, Cells{&cells.baseline}, "mug", {.num_threads = 3});
  EXPECT_EQ(one.log_loss.low, three.log_loss.low);
  EXPECT_EQ(one.log_loss.high, three.log_loss.high);
}

}  // namespace
}  // namespace handcraft::experiments
