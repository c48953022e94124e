// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/rejection.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"
#include "trainers/svm/margins.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;
using Margins = std::vector<double>;

TEST(CalibrateRejection, SeparatesWhatCanBeSeparated) {
  const Rejection rejection = CalibrateRejection(Margins{2.0, 1.0, 3.0}, Margins{-1.0, 0.5});
  EXPECT_EQ(rejection.threshold, 0.75);
  EXPECT_EQ(rejection.FalseRejection(), 0.0);
  EXPECT_EQ(rejection.FalseAcceptance(), 0.0);
  EXPECT_EQ(rejection.BalancedAccuracy(), 1.0);
}

TEST(CalibrateRejection, ByHandWhereTheyOverlap) {
  // Sorted: novel 0, known 1, novel 2, known 3, known 4: at 2.5 one of three known is lost.
  const Rejection rejection = CalibrateRejection(Margins{1.0, 3.0, 4.0}, Margins{0.0, 2.0});
  EXPECT_EQ(rejection.threshold, 2.5);
  EXPECT_DOUBLE_EQ(rejection.FalseRejection(), 1.0 / 3.0);
  EXPECT_EQ(rejection.FalseAcceptance(), 0.0);
}

TEST(CalibrateRejection, RejectsNothingWhenNovelSamplesLookSurer) {
  const Rejection rejection = CalibrateRejection(Margins{0.0, 1.0}, Margins{2.0, 3.0});
  EXPECT_EQ(rejection.threshold, 0.0);  // a margin of 0 is not below it
  EXPECT_EQ(rejection.FalseRejection(), 0.0);
  EXPECT_EQ(rejection.FalseAcceptance(), 1.0);
}

TEST(CalibrateRejection, EqualMarginsAreOnOneSide) {
  const Rejection rejection = CalibrateRejection(Margins{1.0, 1.0}, Margins{1.0, 1.0});
  EXPECT_EQ(rejection.threshold, 1.0);
  EXPECT_EQ(rejection.BalancedAccuracy(), 0.5);
}

TEST(CalibrateRejection, IsTheBestOfAllThresholdsAndCountsRight) {
  Rng rng(61);
  for (int round = 0; round < 50; ++round) {
    Margins known;
    Margins novel;
    for (int i = 0; i < 12; ++i) known.push_back(rng.Normal() + 1.0);
    for (int i = 0; i < 7; ++i) novel.push_back(rng.Normal());
    const auto accuracy = [&](double threshold) {
      double kept = 0.0;
      double rejected = 0.0;
      for (const double margin : known) kept += margin >= threshold ? 1.0 : 0.0;
      for (const double margin : novel) rejected += margin < threshold ? 1.0 : 0.0;
      return 0.5 * (kept / 12.0 + rejected / 7.0);
    };
    const Rejection rejection = CalibrateRejection(known, novel);
    EXPECT_NEAR(accuracy(rejection.threshold), rejection.BalancedAccuracy(), 1e-12);
    for (const double threshold : known) {
      EXPECT_LE(accuracy(threshold), rejection.BalancedAccuracy() + 1e-12);
    }
  }
}

TEST(CalibrateRejection, LosesNoMoreKnownSamplesThanAllowed) {
  // Sorted: known 0, novel 1, 2, known 3, 4: finding both novel ones costs the first known one.
  const Margins known = {0.0, 3.0, 4.0};
  const Margins novel = {1.0, 2.0};
  EXPECT_EQ(CalibrateRejection(known, novel).threshold, 2.5);
  EXPECT_EQ(CalibrateRejection(known, novel, 0.34).threshold, 2.5);
  const Rejection none = CalibrateRejection(known, novel, 0.33);
  EXPECT_EQ(none.threshold, 0.0);
  EXPECT_EQ(none.num_known_rejected, 0U);
  EXPECT_EQ(none.num_novel_rejected, 0U);
}

TEST(RejectionTradeOff, ByHand) {
  const std::vector<Rejection> all = RejectionTradeOff(Margins{1.0, 3.0, 4.0}, Margins{1.0, 2.0});
  ASSERT_EQ(all.size(), 4U);  // the smallest margin, then between 1, 2, 3 and 4
  const Margins thresholds = {1.0, 1.5, 2.5, 3.5};
  const std::vector<std::size_t> known = {0, 1, 1, 2};
  const std::vector<std::size_t> novel = {0, 1, 2, 2};
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].threshold, thresholds[i]);
    EXPECT_EQ(all[i].num_known_rejected, known[i]) << i;
    EXPECT_EQ(all[i].num_novel_rejected, novel[i]) << i;
    EXPECT_EQ(all[i].num_known, 3U);
    EXPECT_EQ(all[i].num_novel, 2U);
  }
}

// Finding more novel samples never gives a known one back.
TEST(RejectionTradeOff, WhatFindsMoreNovelOnesLosesNoFewerKnownOnes) {
  Rng rng(62);
  for (int round = 0; round < 50; ++round) {
    Margins known;
    Margins novel;
    for (int i = 0; i < 30; ++i) known.push_back(0.1 * static_cast<double>(rng.UniformInt(40)));
    for (int i = 0; i < 20; ++i) novel.push_back(0.1 * static_cast<double>(rng.UniformInt(30)));
    const std::vector<Rejection> all = RejectionTradeOff(known, novel);
    for (std::size_t i = 1; i < all.size(); ++i) {
      EXPECT_GT(all[i].threshold, all[i - 1].threshold);
      EXPECT_GE(all[i].num_known_rejected, all[i - 1].num_known_rejected);
      EXPECT_GE(all[i].num_novel_rejected, all[i - 1].num_novel_rejected);
      EXPECT_GT(all[i].num_known_rejected + all[i].num_novel_rejected,
                all[i - 1].num_known_rejected + all[i - 1].num_novel_rejected);
    }
    // A stricter limit never finds more.
    std::size_t found = novel.size() + 1;
    for (const double limit : {1.0, 0.5, 0.2, 0.1, 0.0}) {
      const Rejection chosen = ChooseRejection(all, limit);
      EXPECT_LE(chosen.FalseRejection(), limit);
      EXPECT_LE(chosen.num_novel_rejected, found);
      found = chosen.num_novel_rejected;
    }
  }
}

TEST(RejectNovel, SetsTheThresholdBetweenKnownAndNovelMargins) {
  model_io::SvmModel model = testing::SomeSvm();
  const std::vector<double> rows = {1.0, 0.5, 0.75, 0.0};
  const DesignMatrix<double> novel{rows.data(), 2, 2, 2};
  const std::vector<double> margins = MarginsOf(model, novel);
  const double largest = std::max(margins[0], margins[1]);
  const Calibration calibration =
      RejectNovel(Margins{largest + 1.0, largest + 2.0}, novel, 1.0, 1, model);
  EXPECT_EQ(model.rejection_threshold, largest + 0.5);
  EXPECT_EQ(calibration.chosen.num_novel_rejected, 2U);
  EXPECT_EQ(calibration.chosen.num_known_rejected, 0U);
  const std::vector<double> wide = {1.0, 2.0, 3.0};
  EXPECT_THROWS_MESSAGE(
      RejectNovel(Margins{1.0}, DesignMatrix<double>{wide.data(), 1, 3, 3}, 1.0, 1, model),
      Error,
      HasSubstr("the samples have 3 features and the model 2"));
  const std::vector<double> broken = {1.0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_THROWS_MESSAGE(
      RejectNovel(Margins{1.0}, DesignMatrix<double>{broken.data(), 1, 2, 2}, 1.0, 1, model),
      Error,
      HasSubstr("a margin of a novel sample is not a finite number"));
  EXPECT_EQ(model.rejection_threshold, largest + 0.5);  // as it was
}

TEST(CalibrateRejection, RefusesNothingAndNan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROWS_MESSAGE(
      CalibrateRejection({}, Margins{1.0}), Error, HasSubstr("no margins of known samples"));
  EXPECT_THROWS_MESSAGE(
      CalibrateRejection(Margins{1.0}, {}), Error, HasSubstr("no margins of novel samples"));
  EXPECT_THROWS_MESSAGE((CalibrateRejection(Margins{1.0}, Margins{0.0, nan})),
                        Error,
                        HasSubstr("a margin of a novel sample is not a finite number"));
}

}  // namespace
}  // namespace handcraft::svm
