// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "tests/experiments/evaluation/hand_filled_evaluation.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> KeysOf(const nlohmann::ordered_json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(GraspPointJson, HasTheDocumentedKeys) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const auto json = nlohmann::ordered_json::parse(ToJson(hand.evaluation, hand.set));
  EXPECT_THAT(KeysOf(json),
              ElementsAre("kind",
                          "data_fingerprint",
                          "options",
                          "num_images",
                          "num_images_without_best_pixel",
                          "best_pixels_counted",
                          "best_pixels_good",
                          "best_pixels_dont_care",
                          "best_pixel_accuracy",
                          "best_pixel_accuracy_interval",
                          "num_pixels",
                          "accuracy",
                          "accuracy_interval",
                          "auc",
                          "auc_interval",
                          "average_precision",
                          "average_precision_interval",
                          "log_loss",
                          "log_loss_interval",
                          "brier",
                          "brier_interval",
                          "confusion",
                          "true_positive_rate",
                          "true_positive_rate_interval",
                          "true_negative_rate",
                          "true_negative_rate_interval",
                          "strict_accuracy",
                          "strict_accuracy_interval",
                          "strict_confusion",
                          "strict_true_positive_rate",
                          "strict_true_positive_rate_interval",
                          "strict_true_negative_rate",
                          "strict_true_negative_rate_interval",
                          "classes",
                          "roc",
                          "roc_band",
                          "precision_recall",
                          "precision_recall_band",
                          "reliability",
                          "images"));
  EXPECT_THAT(KeysOf(json["images"][0]),
              ElementsAre("image",
                          "class",
                          "instance",
                          "best_pixels_good",
                          "best_pixels_bad",
                          "best_pixels_dont_care",
                          "best_pixels"));
}

TEST(GraspPointJson, HoldsTheFigures) {
  const auto hand = testing::MakeHandFilledEvaluation();
  const auto json = nlohmann::json::parse(ToJson(hand.evaluation, hand.set));
  EXPECT_DOUBLE_EQ(json["accuracy"], 4.0 / 7.0);
  EXPECT_DOUBLE_EQ(json["best_pixel_accuracy"], 2.0 / 3.0);
  EXPECT_EQ(json["confusion"]["true_positive"], 2);
  EXPECT_EQ(json["strict_confusion"]["true_positive"], 0);
  EXPECT_EQ(json["precision_recall"].size(), 7U);
  EXPECT_DOUBLE_EQ(json["precision_recall"][0][0], 1.0 / 3.0);
  EXPECT_EQ(json["classes"][1]["class"], "pen <x>");
  EXPECT_TRUE(json["classes"][1]["auc"].is_null());
  EXPECT_EQ(json["images"][0]["best_pixels"][2]["label"], "bad");
  EXPECT_EQ(json["images"][0]["best_pixels"][2]["probability"], 0.91);
  EXPECT_EQ(json["images"][2]["best_pixels"][0]["label"], "dont_care");
  EXPECT_DOUBLE_EQ(json["true_positive_rate"], 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(json["true_negative_rate"], 0.5);
  EXPECT_EQ(json["strict_true_positive_rate"], 0.0);
  EXPECT_EQ(json["reliability"].size(), 10U);
  EXPECT_DOUBLE_EQ(json["reliability"][4]["good_share"], 1.0);
  ASSERT_EQ(json["roc_band"].size(), 101U);
  EXPECT_EQ(json["roc_band"][100], nlohmann::json({1.0, 1.0, 1.0}));
  EXPECT_EQ(json["precision_recall_band"].size(), 100U);
}

TEST(GraspPointJson, HoldsNoTimesAndNoThreads) {
  auto hand = testing::MakeHandFilledEvaluation();
  const std::string text = ToJson(hand.evaluation, hand.set);
  hand.evaluation.images[0].score_ms = 777.0;
  hand.evaluation.options.num_threads = 4;
  EXPECT_EQ(ToJson(hand.evaluation, hand.set), text);
  EXPECT_THAT(text, Not(HasSubstr("_ms")));
}

}  // namespace
}  // namespace handcraft::experiments
