// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/rejection.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;
using Margins = std::vector<double>;

TEST(CalibrateRejection, SeparatesWhatCanBeSeparated) {
  const Rejection rejection = CalibrateRejection(Margins{2.0, 1.0, 3.0}, Margins{-1.0, 0.5});
  EXPECT_EQ(rejection.threshold, 0.75);
  EXPECT_EQ(rejection.false_rejection, 0.0);
  EXPECT_EQ(rejection.false_acceptance, 0.0);
  EXPECT_EQ(rejection.balanced_accuracy, 1.0);
}

TEST(CalibrateRejection, ByHandWhereTheyOverlap) {
  // Sorted: novel 0, known 1, novel 2, known 3, known 4: at 2.5 one of three known is lost.
  const Rejection rejection = CalibrateRejection(Margins{1.0, 3.0, 4.0}, Margins{0.0, 2.0});
  EXPECT_EQ(rejection.threshold, 2.5);
  EXPECT_DOUBLE_EQ(rejection.false_rejection, 1.0 / 3.0);
  EXPECT_EQ(rejection.false_acceptance, 0.0);
}

TEST(CalibrateRejection, RejectsNothingWhenNovelSamplesLookSurer) {
  const Rejection rejection = CalibrateRejection(Margins{0.0, 1.0}, Margins{2.0, 3.0});
  EXPECT_EQ(rejection.threshold, 0.0);  // a margin of 0 is not below it
  EXPECT_EQ(rejection.false_rejection, 0.0);
  EXPECT_EQ(rejection.false_acceptance, 1.0);
}

TEST(CalibrateRejection, EqualMarginsAreOnOneSide) {
  const Rejection rejection = CalibrateRejection(Margins{1.0, 1.0}, Margins{1.0, 1.0});
  EXPECT_EQ(rejection.threshold, 1.0);
  EXPECT_EQ(rejection.balanced_accuracy, 0.5);
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
    EXPECT_NEAR(accuracy(rejection.threshold), rejection.balanced_accuracy, 1e-12);
    for (const double threshold : known) {
      EXPECT_LE(accuracy(threshold), rejection.balanced_accuracy + 1e-12);
    }
  }
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
