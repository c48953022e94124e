// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/json_text.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

TEST(JsonText, KeepsTheOrderOfKeysAndEndsTheLine) {
  nlohmann::ordered_json json;
  json["z"] = 1;
  json["a"] = 0.1;
  EXPECT_EQ(JsonText(json), "{\n  \"z\": 1,\n  \"a\": 0.1\n}\n");
}

TEST(JsonText, WritesNaNAsNullAndReplacesBrokenUtf8) {
  nlohmann::ordered_json json;
  AddEstimate("auc", {std::numeric_limits<double>::quiet_NaN(), 0.25, 0.75}, json);
  json["name"] = "caf\xE9";
  const auto parsed = nlohmann::json::parse(JsonText(json));
  EXPECT_TRUE(parsed["auc"].is_null());
  EXPECT_EQ(parsed["auc_interval"], nlohmann::json({0.25, 0.75}));
  EXPECT_EQ(parsed["name"], "caf\xEF\xBF\xBD");
}

TEST(ShortestDouble, ReadsBackAsTheSameFloat) {
  EXPECT_EQ(ShortestDouble(0.9F), 0.9);
  EXPECT_EQ(ShortestDouble(1.0F), 1.0);
  EXPECT_EQ(ShortestDouble(1e-7F), 1e-7);
  EXPECT_EQ(static_cast<float>(ShortestDouble(0.123456789F)), 0.123456789F);
}

TEST(ConfusionJson, NamesTheFourCounts) {
  const auto json = ConfusionJson(
      {.true_positive = 1, .false_positive = 2, .true_negative = 3, .false_negative = 4});
  EXPECT_EQ(json.dump(),
            R"({"true_positive":1,"false_positive":2,"true_negative":3,"false_negative":4})");
}

TEST(RocJson, IsAListOfPairs) {
  EXPECT_EQ(RocJson(std::vector<RocPoint>{{0.0, 0.5}, {1.0, 1.0}}).dump(), "[[0.0,0.5],[1.0,1.0]]");
  EXPECT_EQ(RocJson({}).dump(), "[]");
}

}  // namespace
}  // namespace handcraft::experiments
