// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/class_vote.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace handcraft::features {
namespace {

ClassVote Vote(ClassScheme scheme, std::size_t num_classes, const std::vector<double>& values) {
  std::vector<std::int32_t> votes(num_classes);
  return VoteForClass(scheme, values, votes);
}

TEST(PairIndex, CountsUpByTheSecondClass) {
  std::size_t next = 0;
  for (std::size_t b = 1; b < 6; ++b) {
    for (std::size_t a = 0; a < b; ++a) EXPECT_EQ(PairIndex(a, b), next++);
  }
  EXPECT_EQ(NumMachines(ClassScheme::kOneAgainstOne, 6), next);
  EXPECT_EQ(NumMachines(ClassScheme::kOneAgainstAll, 6), 6U);
  EXPECT_EQ(NumMachines(ClassScheme::kOneAgainstAll, 2), 1U);
}

TEST(VoteForClass, OneAgainstOneByHand) {
  // Pairs (0,1), (0,2), (1,2): class 1 beats both, the other by 0.5.
  const ClassVote vote = Vote(ClassScheme::kOneAgainstOne, 3, {-2.0, 1.0, 0.5});
  EXPECT_EQ(vote.winner, 1U);
  EXPECT_EQ(vote.margin, 0.5);
}

TEST(VoteForClass, OfEqualVotesTheFirstWinsAndItsMarginTellsSo) {
  // A circle: 0 beats 1, 1 beats 2, 2 beats 0.
  const ClassVote vote = Vote(ClassScheme::kOneAgainstOne, 3, {1.0, -3.0, 2.0});
  EXPECT_EQ(vote.winner, 0U);
  EXPECT_EQ(vote.margin, -3.0);
}

TEST(VoteForClass, ZeroIsAVoteForTheSecondClass) {
  EXPECT_EQ(Vote(ClassScheme::kOneAgainstOne, 2, {0.0}).winner, 1U);
}

TEST(VoteForClass, TwoClassesAreOneMachineInEitherScheme) {
  EXPECT_EQ(Vote(ClassScheme::kOneAgainstAll, 2, {0.5}).winner, 0U);
  EXPECT_EQ(Vote(ClassScheme::kOneAgainstAll, 2, {-0.5}).winner, 1U);
  EXPECT_EQ(Vote(ClassScheme::kOneAgainstAll, 2, {-0.5}).margin, 0.5);
}

TEST(VoteForClass, OneAgainstAllTakesTheLargest) {
  const ClassVote vote = Vote(ClassScheme::kOneAgainstAll, 4, {-1.0, -0.25, -3.0, -0.25});
  EXPECT_EQ(vote.winner, 1U);
  EXPECT_EQ(vote.margin, -0.25);
}

}  // namespace
}  // namespace handcraft::features
