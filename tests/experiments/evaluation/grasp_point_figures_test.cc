// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_figures.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/experiments/evaluation/hand_filled_evaluation.h"

namespace handcraft::experiments {
namespace {

// Forty images with ten pixels and up to three best pixels each.
std::vector<ImageScore> RandomImages(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<ImageScore> images(40);
  for (std::size_t i = 0; i < images.size(); ++i) {
    images[i].item = i;
    for (int k = 0; k < 10; ++k) {
      images[i].labels.push_back(static_cast<std::uint8_t>(k % 2));
      images[i].probabilities.push_back(
          static_cast<float>(0.8 * rng.Uniform() + 0.2 * images[i].labels.back()));
    }
    for (std::uint64_t k = rng.UniformInt(4); k > 0; --k) {
      images[i].best.push_back(
          {0, 0, 0.95F, static_cast<std::uint8_t>(rng.UniformInt(2) == 0 ? 0 : 255)});
    }
  }
  return images;
}

std::vector<const ImageScore*> PointersTo(const std::vector<ImageScore>& images) {
  std::vector<const ImageScore*> pointers;
  pointers.reserve(images.size());
  for (const ImageScore& image : images) pointers.push_back(&image);
  return pointers;
}

TEST(CountBestPixels, SortsThemByGround) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const BestPixelCounts counts = CountBestPixels(hand.evaluation.images[0]);
  EXPECT_EQ(counts.good, 2U);
  EXPECT_EQ(counts.bad, 1U);
  EXPECT_EQ(counts.dont_care, 0U);
  EXPECT_EQ(CountBestPixels(hand.evaluation.images[2]).dont_care, 1U);
}

TEST(FormFigures, CountsByHand) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const GroupFigures& all = hand.evaluation.all;
  EXPECT_EQ(all.num_images, 3U);
  EXPECT_EQ(all.num_images_without_best, 1U);
  EXPECT_EQ(all.best_good, 2U);
  EXPECT_EQ(all.best_total, 3U);  // the don't-care pixel is left out
  EXPECT_EQ(all.best_dont_care, 1U);
  EXPECT_DOUBLE_EQ(all.best_pixel_accuracy.value, 2.0 / 3.0);
  EXPECT_EQ(all.confusion.true_positive, 2U);
  EXPECT_EQ(all.confusion.false_negative, 1U);
  EXPECT_EQ(all.confusion.true_negative, 2U);
  EXPECT_EQ(all.confusion.false_positive, 2U);
  EXPECT_DOUBLE_EQ(all.accuracy.value, 4.0 / 7.0);
  // Good .9 .7 .4 against bad .8 .6 .2 .1: 4 + 3 + 2 of 12 pairs are won.
  EXPECT_DOUBLE_EQ(all.auc.value, 9.0 / 12.0);
  EXPECT_NEAR(all.brier.value, (0.01 + 0.09 + 0.36 + 0.36 + 0.04 + 0.01 + 0.64) / 7.0, 1e-7);
  EXPECT_LT(all.brier.low, all.brier.value);
  EXPECT_GT(all.log_loss.high, all.log_loss.value);
  // Good at places 1, 3 and 5 of seven.
  EXPECT_NEAR(all.average_precision.value, (1.0 + 2.0 / 3.0 + 3.0 / 5.0) / 3.0, 1e-12);
  // Above 0.9 there is the pixel at 0.9F, which is a little less: none.
  EXPECT_EQ(all.strict_confusion.true_positive + all.strict_confusion.false_positive, 0U);
  EXPECT_DOUBLE_EQ(all.strict_accuracy.value, 4.0 / 7.0);
  EXPECT_EQ(hand.evaluation.curves.roc.size(), 8U);
  EXPECT_EQ(hand.evaluation.curves.precision_recall.size(), 7U);
}

TEST(FormFigures, ListsClassesByName) {
  const auto hand = testing::MakeHandFilledEvaluation();
  ASSERT_EQ(hand.evaluation.classes.size(), 2U);
  const GroupFigures& cup = hand.evaluation.classes[0];
  const GroupFigures& pen = hand.evaluation.classes[1];
  EXPECT_EQ(cup.name, "cup");
  EXPECT_EQ(cup.num_images, 2U);
  EXPECT_DOUBLE_EQ(cup.best_pixel_accuracy.value, 2.0 / 3.0);
  EXPECT_EQ(pen.name, "pen <x>");
  // Its only best pixel is don't care and its pixels are of one kind: nothing to stand on.
  EXPECT_TRUE(std::isnan(pen.best_pixel_accuracy.value));
  EXPECT_TRUE(std::isnan(pen.best_pixel_accuracy.low));
  EXPECT_TRUE(std::isnan(pen.auc.value));
  EXPECT_DOUBLE_EQ(pen.accuracy.value, 0.0);
}

TEST(ComputeGroupFigures, PutsValuesInsideTheirIntervals) {
  const std::vector<ImageScore> images = RandomImages(1);
  const GroupFigures figures = ComputeGroupFigures("all", PointersTo(images), {});
  for (const Estimate& e : {figures.best_pixel_accuracy, figures.accuracy, figures.auc}) {
    EXPECT_LT(e.low, e.value);
    EXPECT_GT(e.high, e.value);
    EXPECT_GT(e.low, 0.0);
    EXPECT_LT(e.high, 1.0);
  }
}

TEST(ComputeGroupFigures, ClaimsNoCertaintyFromAFewImagesThatAgree) {
  std::vector<ImageScore> images(4);
  for (std::size_t i = 0; i < 3; ++i) images[i].best = {{0, 0, 0.95F, 255}, {1, 0, 0.95F, 255}};
  const GroupFigures figures = ComputeGroupFigures("all", PointersTo(images), {});
  // Three images count, the fourth has no best pixel.
  const Estimate wilson = WilsonInterval(3, 3);
  EXPECT_EQ(figures.best_pixel_accuracy.value, 1.0);
  EXPECT_EQ(figures.best_pixel_accuracy.low, wilson.low);
  EXPECT_EQ(figures.best_pixel_accuracy.high, 1.0);
  EXPECT_EQ(figures.num_images_without_best, 1U);
}

TEST(ComputeGroupFigures, HasNoIntervalForOneImage) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const ImageScore* only = hand.evaluation.images.data();
  const GroupFigures figures = ComputeGroupFigures("all", {&only, 1}, {});
  EXPECT_DOUBLE_EQ(figures.best_pixel_accuracy.value, 2.0 / 3.0);
  EXPECT_TRUE(std::isnan(figures.best_pixel_accuracy.low));
  EXPECT_TRUE(std::isnan(figures.auc.high));
}

TEST(ComputeGroupFigures, HasNoIntervalForOneImageThatIsAllRightOrAllWrong) {
  for (const std::uint8_t ground : {datasets::kMaskGood, datasets::kMaskBad}) {
    std::vector<ImageScore> images(1);
    images[0].best = {{0, 0, 0.95F, ground}};
    images[0].probabilities = {0.95F};
    images[0].labels = {static_cast<std::uint8_t>(ground == datasets::kMaskGood)};
    const GroupFigures figures = ComputeGroupFigures("all", PointersTo(images), {});
    const double share = ground == datasets::kMaskGood ? 1.0 : 0.0;
    for (const Estimate& estimate : {figures.best_pixel_accuracy, figures.accuracy}) {
      EXPECT_EQ(estimate.value, share);
      EXPECT_TRUE(std::isnan(estimate.low));
      EXPECT_TRUE(std::isnan(estimate.high));
    }
  }
}

TEST(ComputeGroupFigures, DoesNotDependOnThreads) {
  const std::vector<ImageScore> images = RandomImages(2);
  const GroupFigures one = ComputeGroupFigures("all", PointersTo(images), {.num_threads = 1});
  const GroupFigures four = ComputeGroupFigures("all", PointersTo(images), {.num_threads = 4});
  EXPECT_EQ(one.auc.low, four.auc.low);
  EXPECT_EQ(one.auc.high, four.auc.high);
  EXPECT_EQ(one.best_pixel_accuracy.low, four.best_pixel_accuracy.low);
  EXPECT_EQ(one.accuracy.high, four.accuracy.high);
}

TEST(ComputeGroupFigures, IsUndefinedWithoutImages) {
  const GroupFigures figures = ComputeGroupFigures("none", {}, {});
  EXPECT_EQ(figures.num_images, 0U);
  EXPECT_TRUE(std::isnan(figures.best_pixel_accuracy.value));
  EXPECT_TRUE(std::isnan(figures.accuracy.value));
  EXPECT_TRUE(std::isnan(figures.log_loss.value));
}

TEST(PoolPixels, PutsImagesInARow) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const PooledPixels pooled = PoolPixels(hand.evaluation.images);
  EXPECT_EQ(pooled.labels, (std::vector<std::uint8_t>{1, 1, 0, 0, 1, 0, 0}));
  EXPECT_EQ(pooled.probabilities.back(), 0.8F);
}

}  // namespace
}  // namespace handcraft::experiments
