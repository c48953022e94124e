// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/runtime_scoring.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/evaluation/edge_model.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ScoreWithRuntime, GivesTheProbabilitiesOfAStepByHand) {
  const testing::ModelOwner model = testing::MakeEdgeModel();
  const RuntimeScores scores = ScoreWithRuntime(model.get(), testing::MakeBand(20, 40), "step.png");
  EXPECT_EQ(scores.probabilities.width(), testing::kEdgeWidth);
  EXPECT_EQ(scores.probabilities.height(), testing::kEdgeHeight);
  for (const int v : {0, 7, 19}) {
    EXPECT_NEAR(scores.probabilities.At(19, v), 0.9933071F, 1e-6F);  // 1 / (1 + e^−5)
    EXPECT_NEAR(scores.probabilities.At(20, v), 0.9933071F, 1e-6F);
    EXPECT_NEAR(scores.probabilities.At(18, v), 0.0066929F, 1e-6F);
    EXPECT_NEAR(scores.probabilities.At(5, v), 3.059e-7F, 1e-9F);
  }
  EXPECT_GT(scores.score_ms, 0.0);
}

TEST(ScoreWithRuntime, TakesGrayAndColour) {
  const testing::ModelOwner model = testing::MakeEdgeModel();
  const Image gray = testing::MakeBand(20, 40);
  Image colour(gray.width(), gray.height(), 3);
  for (int v = 0; v < gray.height(); ++v) {
    for (int i = 0; i < 3 * gray.width(); ++i) colour.Row(v)[i] = gray.Row(v)[i / 3];
  }
  EXPECT_EQ(ScoreWithRuntime(model.get(), gray, "").probabilities.values(),
            ScoreWithRuntime(model.get(), colour, "").probabilities.values());
}

TEST(ScoreWithRuntime, ScoresThePixelsOfAMaskAlone) {
  const testing::ModelOwner model = testing::MakeEdgeModel();
  const Image picture = testing::MakeBand(20, 40);
  Image mask(picture.width(), picture.height());
  mask.At(19, 7) = 255;
  const FloatImage all = ScoreWithRuntime(model.get(), picture, "").probabilities;
  const FloatImage some = ScoreWithRuntime(model.get(), picture, "", &mask).probabilities;
  EXPECT_EQ(some.At(19, 7), all.At(19, 7));
  EXPECT_EQ(some.At(20, 7), 0.0F);
  const Image small(3, 3);
  EXPECT_THROWS_MESSAGE(ScoreWithRuntime(model.get(), picture, "step.png", &small),
                        std::logic_error,
                        HasSubstr("step.png"));
}

TEST(ScoreWithRuntime, NamesTheImageItCannotScore) {
  const testing::ModelOwner model = testing::MakeEdgeModel();
  EXPECT_THROWS_MESSAGE(ScoreWithRuntime(model.get(), Image(), "empty.png"),
                        Error,
                        AllOf(StartsWith("empty.png"), HasSubstr("cannot score this image")));
}

TEST(FindBestPixels, ListsThoseAboveTheThresholdBestFirst) {
  FloatImage probabilities(4, 2);
  probabilities.At(1, 0) = 0.95F;
  probabilities.At(3, 1) = 0.99F;
  probabilities.At(0, 1) = 0.95F;
  probabilities.At(2, 0) = 0.9F;  // not above
  const std::vector<hc_point> best = FindBestPixels(probabilities, 15, 0.9, 0);
  ASSERT_EQ(best.size(), 3U);
  EXPECT_EQ(best[0].u, 3);
  EXPECT_EQ(best[0].v, 1);
  EXPECT_EQ(best[1].u, 1);  // ties: the smaller row first
  EXPECT_EQ(best[2].u, 0);
  EXPECT_EQ(FindBestPixels(probabilities, 1, 0.9, 0).size(), 1U);
  EXPECT_EQ(FindBestPixels(probabilities, 15, 0.9, 2).size(), 2U);
  EXPECT_TRUE(FindBestPixels(probabilities, 15, 0.99, 0).empty());
  EXPECT_THROWS_MESSAGE(
      FindBestPixels(probabilities, 0, 0.9, 0), std::logic_error, HasSubstr("max_count"));
}

}  // namespace
}  // namespace handcraft::experiments
