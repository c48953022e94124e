// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/lda/lda.h"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/lda/two_classes.h"

namespace handcraft::lda {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Class 0 at −1 ± 1, class 1 at 3 ± 1: variance 4/(4 − 2) = 2, w = 4/2, threshold at 1.
TEST(Lda, OfOneFeatureByHand) {
  const TwoClasses data{.num_features = 1, .values = {-2.0, 0.0, 2.0, 4.0}, .labels = {0, 0, 1, 1}};
  const Result result = TrainLda(data.X(), data.labels);
  EXPECT_EQ(result.summary.termination, Termination::kSolved);
  EXPECT_NEAR(result.weights[0], 2.0, 1e-15);
  EXPECT_NEAR(result.intercept, -2.0, 1e-15);
  const auto log_loss = [](double z) { return std::log1p(std::exp(z)); };
  EXPECT_NEAR(result.summary.deviance, 4.0 * (log_loss(-6.0) + log_loss(-2.0)), 1e-14);
  EXPECT_NEAR(result.summary.null_deviance, 8.0 * std::log(2.0), 1e-14);
}

TEST(Lda, PriorMovesTheThresholdAlone) {
  const TwoClasses data = DrawTwoClasses(300, 3, 1.0, 3);
  const Result half = TrainLda(data.X(), data.labels, {.positive_prior = 0.5});
  const Result fifth = TrainLda(data.X(), data.labels, {.positive_prior = 0.2});
  const Result own = TrainLda(data.X(), data.labels);
  EXPECT_EQ(half.weights, fifth.weights);
  EXPECT_NEAR(fifth.intercept - half.intercept, std::log(0.25), 1e-12);
  EXPECT_NEAR(own.intercept - half.intercept, std::log(0.5), 1e-12);  // a third is positive
  EXPECT_NEAR(own.summary.positive_prior, 1.0 / 3.0, 1e-15);
}

std::map<std::string, double> ReadReference(const std::string& name) {
  std::istringstream lines(ReadTextFile(std::string(HANDCRAFT_SOURCE_DIR) +
                                        "/tests/data/trainers/lda_" + name + ".csv"));
  std::map<std::string, double> reference;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    reference[line.substr(0, line.find(','))] = std::stod(line.substr(line.find(',') + 1));
  }
  return reference;
}

class ScikitLearn : public ::testing::TestWithParam<const char*> {};

TEST_P(ScikitLearn, AgreesToNineDigits) {
  const TwoClasses data = ReadTwoClasses(GetParam());
  for (const ShrinkageRule rule : {ShrinkageRule::kFixed, ShrinkageRule::kLedoitWolf}) {
    const bool fixed = rule == ShrinkageRule::kFixed;
    const auto expected = ReadReference(std::string(GetParam()) + (fixed ? "" : "_ledoit_wolf"));
    const Result result = TrainLda(data.X(), data.labels, {.shrinkage_rule = rule});
    ASSERT_EQ(result.summary.termination, Termination::kSolved);
    const auto expect_near = [&](double actual, const std::string& term) {
      EXPECT_NEAR(actual, expected.at(term), 1e-9 * std::abs(expected.at(term))) << term;
    };
    expect_near(result.intercept, "(Intercept)");
    for (std::size_t j = 0; j < data.num_features; ++j) {
      expect_near(result.weights[j], "x" + std::to_string(j));
    }
    if (!fixed) expect_near(result.summary.shrinkage, "shrinkage");
  }
}

INSTANTIATE_TEST_SUITE_P(Tables,
                         ScikitLearn,
                         ::testing::Values("iris", "heart", "breast_w"),
                         [](const auto& parameter) { return std::string(parameter.param); });

// Fisher's direction has the largest between-class over within-class scatter: no other has more.
TEST(Lda, DirectionIsFishers) {
  const TwoClasses data = DrawTwoClasses(500, 5, 0.7, 5);
  const Result result = TrainLda(data.X(), data.labels);
  const auto ratio = [&](const std::vector<double>& w) {
    double sums[2] = {};
    double squares[2] = {};
    double counts[2] = {};
    for (std::size_t i = 0; i < data.labels.size(); ++i) {
      double z = 0.0;
      for (std::size_t j = 0; j < 5; ++j) z += w[j] * data.X().Row(i)[j];
      sums[data.labels[i]] += z;
      squares[data.labels[i]] += z * z;
      counts[data.labels[i]] += 1.0;
    }
    const double within =
        squares[0] - sums[0] * sums[0] / counts[0] + squares[1] - sums[1] * sums[1] / counts[1];
    return std::pow(sums[1] / counts[1] - sums[0] / counts[0], 2) / within;
  };
  const double best = ratio(result.weights);
  Rng rng(9);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> other = result.weights;
    for (double& x : other) x += 0.2 * rng.Normal();
    EXPECT_LE(ratio(other), best * (1.0 + 1e-12));
  }
}

TEST(Lda, FollowsUnitsOfTheFeatures) {
  TwoClasses data = DrawTwoClasses(200, 3, 1.0, 7);
  const Result result = TrainLda(data.X(), data.labels, {.shrinkage = 0.3});
  for (std::size_t i = 0; i < 200; ++i) data.values[3 * i + 1] = 1e6 * data.values[3 * i + 1] + 5e7;
  const Result scaled = TrainLda(data.X(), data.labels, {.shrinkage = 0.3});
  EXPECT_NEAR(scaled.weights[1] * 1e6, result.weights[1], 1e-9);
  EXPECT_NEAR(scaled.intercept + 5e7 * scaled.weights[1], result.intercept, 1e-8);
  EXPECT_NEAR(scaled.summary.deviance, result.summary.deviance, 1e-7);
}

TEST(Lda, OfFullShrinkageTakesFeaturesOneByOne) {
  const TwoClasses data = DrawTwoClasses(90, 4, 1.0, 9);
  const Result result = TrainLda(data.X(), data.labels, {.shrinkage = 1.0});
  for (std::size_t j = 0; j < 4; ++j) {
    TwoClasses one{.num_features = 1, .values = {}, .labels = data.labels};
    for (std::size_t i = 0; i < 90; ++i) one.values.push_back(data.X().Row(i)[j]);
    EXPECT_NEAR(result.weights[j], TrainLda(one.X(), one.labels).weights[0], 1e-12);
  }
}

TEST(Lda, IsTheSameForAnyNumberOfThreads) {
  const TwoClasses data = DrawTwoClasses(3000, 6, 1.0, 11);
  const Options options{.shrinkage_rule = ShrinkageRule::kLedoitWolf};
  Options three = options;
  three.num_threads = 3;
  const Result one = TrainLda(data.X(), data.labels, options);
  const Result same = TrainLda(data.X(), data.labels, three);
  EXPECT_EQ(one.weights, same.weights);
  EXPECT_EQ(one.intercept, same.intercept);
  EXPECT_EQ(one.summary.deviance, same.summary.deviance);
}

TEST(Lda, GivesAConstantColumnNoWeightAndSaysSo) {
  TwoClasses data = DrawTwoClasses(60, 3, 1.0, 13);
  for (std::size_t i = 0; i < 60; ++i) data.values[3 * i + 1] = 0.1;
  const Result result = TrainLda(data.X(), data.labels);
  EXPECT_EQ(result.summary.termination, Termination::kSolved);
  EXPECT_THAT(result.summary.constant_features, ElementsAre(1));
  EXPECT_EQ(result.weights[1], 0.0);
  EXPECT_EQ(result.feature_scale[1], 1.0);
}

TEST(Lda, SaysWhichColumnIsConstantWithinClasses) {
  TwoClasses data = DrawTwoClasses(60, 3, 1.0, 13);
  for (std::size_t i = 0; i < 60; ++i) data.values[3 * i + 1] = data.labels[i];
  const Result result = TrainLda(data.X(), data.labels);
  EXPECT_EQ(result.summary.termination, Termination::kSingular);
  EXPECT_THAT(result.summary.message, HasSubstr("column 1 (counted from 0) is constant within"));
  EXPECT_TRUE(result.weights.empty());
}

TEST(Lda, OfMoreColumnsThanRowsNeedsShrinkage) {
  const TwoClasses data = DrawTwoClasses(12, 30, 1.0, 15);
  const Result plain = TrainLda(data.X(), data.labels);
  EXPECT_EQ(plain.summary.termination, Termination::kSingular);
  EXPECT_THAT(plain.summary.message, HasSubstr("30 features from 12 samples is singular"));
  EXPECT_THAT(plain.summary.advice, HasSubstr("shrinkage"));
  const Result shrunk =
      TrainLda(data.X(), data.labels, {.shrinkage_rule = ShrinkageRule::kLedoitWolf});
  EXPECT_EQ(shrunk.summary.termination, Termination::kSolved);
  EXPECT_GT(shrunk.summary.shrinkage, 0.0);
  EXPECT_LT(shrunk.summary.deviance, shrunk.summary.null_deviance);
}

TEST(Lda, RefusesOneClassNoSamplesAndTwo) {
  TwoClasses data = DrawTwoClasses(20, 2, 1.0, 17);
  data.labels.assign(20, 1);
  EXPECT_THROWS_MESSAGE(TrainLda(data.X(), data.labels), Error, HasSubstr("all 20 labels are 1"));
  EXPECT_THROWS_MESSAGE(
      TrainLda(DesignMatrix<double>{}, {}), Error, HasSubstr("all 0 labels are 0"));
  const TwoClasses two{.num_features = 1, .values = {1.0, 2.0}, .labels = {0, 1}};
  EXPECT_THROWS_MESSAGE(
      TrainLda(two.X(), two.labels), Error, HasSubstr("no spread within their classes"));
}

TEST(Lda, NamesTheNumberThatIsNotFinite) {
  TwoClasses data = DrawTwoClasses(20, 3, 1.0, 19);
  data.values[3 * 4 + 2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROWS_MESSAGE(TrainLda(data.X(), data.labels), Error, HasSubstr("row 4, column 2"));
}

TEST(LdaOptions, NameFieldValueAndRule) {
  EXPECT_THROWS_MESSAGE(Options{.shrinkage = 1.5}.Validate(),
                        Error,
                        HasSubstr("lda::Options.shrinkage is 1.5; it must be in [0, 1]"));
  EXPECT_THROWS_MESSAGE(
      (Options{.shrinkage_rule = ShrinkageRule::kLedoitWolf, .shrinkage = 0.1}).Validate(),
      Error,
      HasSubstr("0 with the rule of Ledoit and Wolf"));
  EXPECT_THROWS_MESSAGE(
      Options{.positive_prior = 1.0}.Validate(), Error, HasSubstr("positive_prior is 1"));
  EXPECT_THROWS_MESSAGE(Options{.num_threads = 0}.Validate(), Error, HasSubstr("num_threads is 0"));
}

}  // namespace
}  // namespace handcraft::lda
