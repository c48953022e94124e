// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/grasp_point_evaluation.h"

#include <filesystem>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/evaluation/edge_model.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class EvaluateEdges : public ::testing::Test {
 protected:
  testing::TemporaryDirectory folder_;
  datasets::LabelledImageSet set_ = testing::WriteEdgeSet(folder_.path());
  testing::ModelOwner model_ = testing::MakeEdgeModel();
};

TEST_F(EvaluateEdges, FindsTheFiguresCountedByHand) {
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, {});
  const GroupFigures& all = evaluation.all;
  EXPECT_EQ(all.num_images, 5U);
  EXPECT_EQ(all.best_good, 22U);
  EXPECT_EQ(all.best_total, 45U);
  EXPECT_EQ(all.best_dont_care, 15U);
  EXPECT_EQ(all.num_images_without_best, 1U);
  EXPECT_DOUBLE_EQ(all.best_pixel_accuracy.value, 22.0 / 45.0);
  // Forty good and forty bad pixels in each of four pictures, 800 bad ones in the last.
  EXPECT_EQ(all.confusion.true_positive, 80U);
  EXPECT_EQ(all.confusion.false_negative, 80U);
  EXPECT_EQ(all.confusion.false_positive, 80U);
  EXPECT_EQ(all.confusion.true_negative, 880U);
  EXPECT_DOUBLE_EQ(all.accuracy.value, 960.0 / 1120.0);
}

TEST_F(EvaluateEdges, ScoresEveryImageByTheRuntime) {
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, {});
  ASSERT_EQ(evaluation.images.size(), 5U);
  EXPECT_NEAR(evaluation.images[0].best.front().probability, 0.9933071F, 1e-6F);
  EXPECT_EQ(evaluation.images[0].best.front().u_px, 19);
  EXPECT_EQ(evaluation.images[0].best.front().v_px, 0);
  EXPECT_EQ(evaluation.images[0].best.size(), 15U);
  EXPECT_TRUE(evaluation.images[2].best.empty());
  EXPECT_EQ(evaluation.images[3].best.front().mask_value, datasets::kMaskDontCare);
}

TEST_F(EvaluateEdges, FormsFiguresByClass) {
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, {});
  ASSERT_EQ(evaluation.classes.size(), 2U);
  EXPECT_EQ(evaluation.classes[0].name, "edge");
  EXPECT_EQ(evaluation.classes[0].best_good, 22U);
  EXPECT_EQ(evaluation.classes[0].best_total, 30U);
  // The edge class: 80 good at 0.99 against 40 bad at 0 and 40 tied.
  EXPECT_DOUBLE_EQ(evaluation.classes[0].auc.value, 0.75);
  EXPECT_EQ(evaluation.classes[1].best_good, 0U);
}

TEST_F(EvaluateEdges, CountsFewerBestPixelsAndSuppressesNeighboursWhenAsked) {
  EvaluationOptions options{.best_pixels = 4, .suppression_radius_px = 5};
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, options);
  const std::vector<BestPixel>& best = evaluation.images[0].best;
  ASSERT_EQ(best.size(), 4U);
  for (std::size_t i = 1; i < best.size(); ++i) EXPECT_EQ(best[i].v_px - best[i - 1].v_px, 6);
}

TEST_F(EvaluateEdges, LooksForBestPixelsInsideTheRegionAlone) {
  EvaluationOptions options;
  options.region = [](std::size_t item, const Image& picture) {
    perception::SearchRegion region;
    region.stages = {{.name = "picture", .num_pixels = 100}, {.name = "region", .num_pixels = 9}};
    region.mask = Image(picture.width(), picture.height());
    for (int u = 0; u < region.mask.width(); ++u) region.mask.At(u, 3) = 255;
    region.state = item == 1 ? perception::SearchState::kNoEdges : perception::SearchState::kFound;
    return region;
  };
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model_.get(), set_, options);
  ASSERT_EQ(evaluation.images[0].best.size(), 2U);  // of the edge, two pixels of a row
  EXPECT_EQ(evaluation.images[0].best[0].v_px, 3);
  ASSERT_TRUE(evaluation.images[0].search);
  EXPECT_EQ(evaluation.images[0].search->stages.back().name, "scored");
  EXPECT_EQ(evaluation.images[0].search->stages.back().num_pixels, 9U);
  EXPECT_TRUE(evaluation.images[1].best.empty());
  ASSERT_TRUE(evaluation.images[1].search);
  EXPECT_FALSE(evaluation.images[1].search->has_region);
  EXPECT_EQ(evaluation.all.auc.value, EvaluateGraspPoints(model_.get(), set_, {}).all.auc.value);
}

TEST_F(EvaluateEdges, GivesTheSameBytesForAnyNumberOfThreads) {
  EvaluationOptions options{.pixels_per_image = 30, .num_threads = 1};
  const std::string one = ToJson(EvaluateGraspPoints(model_.get(), set_, options), set_);
  EXPECT_EQ(ToJson(EvaluateGraspPoints(model_.get(), set_, options), set_), one);
  options.num_threads = 3;
  EXPECT_EQ(ToJson(EvaluateGraspPoints(model_.get(), set_, options), set_), one);
  options.seed = 2;
  EXPECT_NE(ToJson(EvaluateGraspPoints(model_.get(), set_, options), set_), one);
}

TEST_F(EvaluateEdges, DrawsOfOneImageDoNotDependOnTheOthers) {
  const EvaluationOptions options{.pixels_per_image = 30};
  datasets::LabelledImageSet last = set_;
  last.items.erase(last.items.begin(), last.items.end() - 1);
  EXPECT_EQ(EvaluateGraspPoints(model_.get(), last, options).images[0].probabilities,
            EvaluateGraspPoints(model_.get(), set_, options).images[4].probabilities);
}

TEST_F(EvaluateEdges, ReportsProgressFromTheCallersThread) {
  const std::thread::id caller = std::this_thread::get_id();
  std::size_t last_done = 0;
  EvaluationOptions options{.num_threads = 3};
  options.progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_EQ(stage, "evaluate");
    EXPECT_EQ(total, 5U);
    EXPECT_GE(done, last_done);
    last_done = done;
  };
  static_cast<void>(EvaluateGraspPoints(model_.get(), set_, options));
  EXPECT_EQ(last_done, 5U);
}

TEST_F(EvaluateEdges, NamesTheImageThatIsMissing) {
  std::filesystem::remove(folder_ / "flat.png");
  EXPECT_THROWS_MESSAGE(EvaluateGraspPoints(model_.get(), set_, {}), Error, HasSubstr("flat.png"));
}

TEST_F(EvaluateEdges, NamesTheImageTheModelCannotScore) {
  const testing::ModelOwner colour_model = testing::LoadModelFile(model_io::MakeGraspPointModel(
      features::ParseFeatureSpec("filters=cb_LL,window=1"),
      {.weights = {1.0}, .intercept = 0.0, .feature_mean = {}, .feature_scale = {}},
      {}));
  EXPECT_THROWS_MESSAGE(EvaluateGraspPoints(colour_model.get(), set_, {}),
                        Error,
                        AllOf(HasSubstr("right.png"), HasSubstr("cannot score this image")));
}

TEST_F(EvaluateEdges, RefusesAnotherKindOfModelAndAnEmptySet) {
  const testing::ModelOwner logistic = testing::LoadModelFile(model_io::MakeLogisticModel(
      {"a"},
      "label",
      "0",
      "1",
      {.weights = {1.0}, .intercept = 0.0, .feature_mean = {}, .feature_scale = {}},
      {}));
  EXPECT_THROWS_MESSAGE(
      EvaluateGraspPoints(logistic.get(), set_, {}), Error, HasSubstr("no grasp-point model"));
  EXPECT_THROWS_MESSAGE(EvaluateGraspPoints(model_.get(), {.root = "empty", .items = {}}, {}),
                        Error,
                        AllOf(HasSubstr("empty"), HasSubstr("no images")));
}

TEST_F(EvaluateEdges, HasNoResultWithoutALabelledPixel) {
  for (const auto& item : set_.items) {
    perception::WritePng(folder_ / item.mask,
                         Image(testing::kEdgeWidth, testing::kEdgeHeight, 1, 128));
  }
  try {
    static_cast<void>(EvaluateGraspPoints(model_.get(), set_, {}));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.details().kind, Error::Kind::kNoResult);
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr(folder_.path().string()),
                      HasSubstr("no pixel of the 5 images is labelled good or bad")));
  }
}

TEST(EvaluationOptions, HaveTheDissertationsDefaults) {
  const EvaluationOptions options;
  EXPECT_EQ(options.best_pixels, 15);
  EXPECT_EQ(options.best_min_probability, 0.9);
  EXPECT_EQ(options.suppression_radius_px, 0);
  EXPECT_EQ(options.threshold, 0.5);
  EXPECT_NO_THROW(options.Validate());
}

TEST(EvaluationOptions, NameTheFieldTheValueAndTheRule) {
  const auto message = [](const EvaluationOptions& options) {
    try {
      options.Validate();
    } catch (const Error& error) {
      EXPECT_EQ(error.details().kind, Error::Kind::kUsage);
      return std::string(error.what());
    }
    return std::string("(nothing was thrown)");
  };
  EXPECT_THAT(message({.threshold = 1.5}),
              HasSubstr("EvaluationOptions.threshold is 1.5; it must be in (0, 1)"));
  EXPECT_THAT(message({.best_pixels = 0}), HasSubstr("best_pixels is 0"));
  EXPECT_THAT(message({.best_min_probability = 1.0}), HasSubstr("in [0, 1)"));
  EXPECT_THAT(message({.suppression_radius_px = -1}), HasSubstr("-1"));
  EXPECT_THAT(message({.pixels_per_image = 1}), HasSubstr("pixels_per_image"));
  EXPECT_THAT(message({.bootstrap_resamples = 0}), HasSubstr("bootstrap_resamples"));
  EXPECT_THAT(message({.num_threads = 0}), HasSubstr("num_threads"));
}

}  // namespace
}  // namespace handcraft::experiments
