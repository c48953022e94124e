// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/machine.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/trainers/svm/drawn_classes.h"

namespace handcraft::svm {
namespace {

using features::ClassScheme;

class MachineProblemTest : public ::testing::Test {
 protected:
  const DrawnClasses<double> drawn_ =
      DrawClasses<double>({.num_classes = 4, .samples_per_class = 6}, 3);
  const Samples samples_ = PrepareSamples(drawn_.Matrix(), drawn_.classes, {});
  const SampleMatrix gram_ = ComputeGram(ComputeInnerProducts(samples_, 1),
                                         {.type = features::SimilarityType::kRbf, .gamma = 0.3},
                                         samples_,
                                         1);
};

TEST(DecisionValue, ByHand) {
  const Machine machine{.support = {0, 2}, .coefficients = {0.5, -2.0}, .intercept = 1.0};
  const std::vector<double> gram_row = {4.0, 100.0, 3.0};
  EXPECT_EQ(DecisionValue(machine, gram_row.data()), -3.0);
}

TEST_F(MachineProblemTest, MembersAreThoseOfThePair) {
  const MachineProblem neighbours(gram_, samples_, ClassScheme::kOneAgainstOne, 0);  // (0, 1)
  EXPECT_EQ(neighbours.Members().front(), 0U);
  EXPECT_EQ(neighbours.Members().back(), 11U);
  const MachineProblem apart(gram_, samples_, ClassScheme::kOneAgainstOne, 3);  // (0, 3)
  ASSERT_EQ(apart.Members().size(), 12U);
  EXPECT_EQ(apart.Members()[5], 5U);
  EXPECT_EQ(apart.Members()[6], 18U);
  const MachineProblem rest(gram_, samples_, ClassScheme::kOneAgainstAll, 2);
  EXPECT_EQ(rest.Members().size(), 24U);
}

TEST_F(MachineProblemTest, SeparatesItsClasses) {
  for (std::size_t pair = 0; pair < 6; ++pair) {
    const MachineProblem problem(gram_, samples_, ClassScheme::kOneAgainstOne, pair);
    const Machine machine = problem.Train(1e4, {});
    ASSERT_TRUE(machine.converged);
    for (std::size_t k = 0; k < 12; ++k) {
      const std::size_t i = problem.Members()[k];
      EXPECT_EQ(DecisionValue(machine, gram_.Row(i)) > 0.0, k < 6) << pair << ' ' << k;
    }
  }
}

TEST_F(MachineProblemTest, LeftOutSamplesSupportNothing) {
  const MachineProblem problem(gram_, samples_, ClassScheme::kOneAgainstOne, 4);
  std::vector<std::uint8_t> left_out(24, 0);
  const Machine whole = problem.Train(1.0, {}, left_out);
  EXPECT_EQ(whole.support, problem.Train(1.0, {}).support);
  left_out[whole.support[0]] = 1;
  const Machine without = problem.Train(1.0, {}, left_out);
  for (const std::size_t i : without.support) EXPECT_NE(i, whole.support[0]);
}

TEST_F(MachineProblemTest, OneAgainstAllIsPositiveForItsClass) {
  const MachineProblem problem(gram_, samples_, ClassScheme::kOneAgainstAll, 2);
  const Machine machine = problem.Train(1e4, {});
  for (std::size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(DecisionValue(machine, gram_.Row(i)) > 0.0, i >= 12 && i < 18) << i;
  }
}

}  // namespace
}  // namespace handcraft::svm
