// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/summary_text.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::logistic {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Result SomeResult() {
  Result result;
  result.weights = {2.0, 0.0};
  result.intercept = -1.5;
  result.standard_errors = {0.5, 0.0};
  result.intercept_standard_error = 1.0;
  result.summary.termination = Termination::kRankDeficient;
  result.summary.message = "one feature left out";
  result.summary.num_samples = 32;
  result.summary.rank = 2;
  result.summary.aliased_features = {1};
  result.summary.deviance = 25.5;
  result.summary.null_deviance = 43.75;
  result.summary.aic = 29.5;
  return result;
}

// R: 2 * pnorm(-c(1, 4)), 17 digits.
TEST(ComputeWaldTest, AgreesWithR) {
  EXPECT_NEAR(ComputeWaldTest(2.0, 2.0).p_value, 0.31731050786291409, 1e-15);
  EXPECT_EQ(ComputeWaldTest(-2.0, 0.5).z, -4.0);
  EXPECT_NEAR(ComputeWaldTest(-2.0, 0.5).p_value, 6.3342483666239957e-05, 1e-18);
}

TEST(SummaryTable, IsLaidOutLikeRs) {
  EXPECT_EQ(SummaryTable(SomeResult(), std::vector<std::string>{"edge", "a longer name"}),
            "Coefficients:\n"
            "                   Estimate    Std. Error   z value  Pr(>|z|)\n"
            "(Intercept)            -1.5             1      -1.5     0.134\n"
            "edge                      2           0.5         4  6.33e-05 ***\n"
            "a longer name            NA            NA        NA        NA\n"
            "---\n"
            "Signif. codes: 0 '***' 0.001 '**' 0.01 '*' 0.05 '.' 0.1 ' ' 1\n"
            "\n"
            "    Null deviance: 43.75  on 31 degrees of freedom\n"
            "Residual deviance: 25.5  on 30 degrees of freedom\n"
            "AIC: 29.5\n"
            "\n"
            "rank_deficient: one feature left out\n"
            "Newton steps: 0 (0 with a subsample's Hessian, 0 halvings); gradient norm 0 a sample; "
            "reciprocal condition 0\n");
}

TEST(SummaryTable, AddsTheAdviceToWhatHappened) {
  Result result = SomeResult();
  result.summary.advice = "set a ridge";
  EXPECT_THAT(SummaryTable(result),
              HasSubstr("rank_deficient: one feature left out; set a ridge\n"));
}

TEST(SummaryTable, NamesFeaturesByNumberAndSaysNaWithoutStandardErrors) {
  Result result = SomeResult();
  result.standard_errors.clear();
  const std::string text = SummaryTable(result);
  EXPECT_THAT(text, HasSubstr("x0                      2            NA        NA        NA\n"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(SummaryTable, WritesTinyPValuesAsR) {
  Result result = SomeResult();
  result.standard_errors[0] = 0.01;
  EXPECT_THAT(SummaryTable(result), HasSubstr("<2e-16 ***"));
}

TEST(SummaryTable, RefusesAWrongNumberOfNames) {
  EXPECT_THROW(static_cast<void>(SummaryTable(SomeResult(), std::vector<std::string>{"one"})),
               std::logic_error);
}

}  // namespace
}  // namespace handcraft::logistic
