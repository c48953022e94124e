// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_rejection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// Margins 0 to 9: novel ones are the even, so that each step finds one or loses one.
svm::Calibration SomeCalibration() {
  const std::vector<double> novel = {0.0, 2.0, 4.0, 6.0, 8.0};
  const std::vector<double> known = {1.0, 3.0, 5.0, 7.0, 9.0};
  svm::Calibration calibration{.chosen = {}, .trade_off = svm::RejectionTradeOff(known, novel)};
  calibration.chosen = svm::ChooseRejection(calibration.trade_off, 0.2);
  return calibration;
}

TEST(FewOf, AreTheLowestThresholdsThatFindAsMany) {
  const std::vector<svm::Rejection> few = FewOf(SomeCalibration().trade_off);
  ASSERT_EQ(few.size(), 3U);  // 3 of 5, 4 of 5, and 5 of 5 once
  EXPECT_EQ(few[0].threshold, 4.5);
  EXPECT_EQ(few[1].threshold, 6.5);
  EXPECT_EQ(few[2].threshold, 8.5);
  EXPECT_EQ(few[2].num_known_rejected, 4U);
  EXPECT_TRUE(FewOf({}).empty());
  // The surest sample is a novel one: no threshold finds it.
  const std::vector<double> known = {0.0};
  const std::vector<double> novel = {1.0};
  EXPECT_TRUE(FewOf(svm::RejectionTradeOff(known, novel)).empty());
}

TEST(RejectionText, TellsBothSharesAndWhatOthersCost) {
  const std::string text = ToText(SomeCalibration(), "views");
  EXPECT_THAT(text,
              AllOf(HasSubstr("below a margin of 0.5: 1 of 5 novel views are found, 20.00 %"),
                    HasSubstr("0 of 5 known ones, held out, are lost, 0.00 %"),
                    HasSubstr("80.00 %"),
                    HasSubstr("--max-lost takes another")));
  EXPECT_THAT(text, Not(HasSubstr("rows")));
}

TEST(RejectionJson, HasThresholdSharesAndTradeOff) {
  nlohmann::ordered_json json;
  AddJson(SomeCalibration(), json);
  EXPECT_EQ(json["rejection_threshold"], 0.5);
  EXPECT_EQ(json["false_rejection"], 0.0);
  EXPECT_EQ(json["false_acceptance"], 0.8);
  EXPECT_EQ(json["num_held_out"], 5);
  EXPECT_EQ(json["num_novel"], 5);
  ASSERT_EQ(json["trade_off"].size(), 3U);
  EXPECT_EQ(json["trade_off"][0]["threshold"], 4.5);
  EXPECT_EQ(json["trade_off"][0]["false_rejection"], 0.4);
}

TEST(RejectionMetrics, StandInTheModelFile) {
  std::map<std::string, std::string> metrics;
  AddMetrics(SomeCalibration(), metrics);
  EXPECT_EQ(metrics.at("rejection.num_novel"), "5");
  EXPECT_EQ(metrics.at("rejection.false_acceptance"), "0.8");
  EXPECT_EQ(metrics.at("rejection.false_rejection"), "0");
}

TEST(NovelOptions, TakeShares) {
  const auto parse = [](const std::string& line) {
    CLI::App app;
    NovelOptions novel;
    AddNovelOptions(app, "DIR", "views", novel);
    app.parse(line);
    return novel;
  };
  EXPECT_EQ(parse("--novel n").max_lost, 1.0);
  EXPECT_EQ(parse("--novel n --max-lost 0.05").max_lost, 0.05);
  EXPECT_THROW(parse("--max-lost 0.05"), CLI::RequiresError);
  for (const char* wrong : {"-0.1", "1.1", "nan", "five"}) {
    EXPECT_THROW(parse("--novel n --max-lost " + std::string(wrong)), CLI::ValidationError);
  }
}

TEST(DroppedThresholdText, TellsWhatItWasAndWhatToDo) {
  EXPECT_THAT(DroppedThresholdText(0.25), AllOf(HasSubstr("0.25"), HasSubstr("--novel")));
}

}  // namespace
}  // namespace handcraft::tools
