// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/lda_options.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;

lda::Options Parse(const std::string& line) {
  CLI::App app;
  lda::Options options;
  AddLdaOptions(app, options);
  app.parse(line);
  return options;
}

TEST(LdaOptions, KeepTheTrainersDefaults) {
  const lda::Options defaults;
  const lda::Options options = Parse("");
  EXPECT_EQ(options.shrinkage, defaults.shrinkage);
  EXPECT_EQ(options.shrinkage_rule, defaults.shrinkage_rule);
  EXPECT_EQ(options.positive_prior, defaults.positive_prior);
}

TEST(LdaOptions, AreTaken) {
  EXPECT_EQ(Parse("--shrinkage 0.25").shrinkage, 0.25);
  const lda::Options options = Parse("--prior 0.2 --shrinkage auto");
  EXPECT_EQ(options.shrinkage_rule, lda::ShrinkageRule::kLedoitWolf);
  EXPECT_EQ(options.positive_prior, 0.2);
}

TEST(LdaOptions, RefuseWhatTheTrainerRefuses) {
  for (const char* line : {"--shrinkage 2", "--shrinkage none", "--prior 1", "--prior -0.5"}) {
    EXPECT_THROW(Parse(line), CLI::ValidationError) << line;
  }
  EXPECT_THROWS_MESSAGE(
      Parse("--shrinkage 2"), CLI::ValidationError, HasSubstr("must be in [0, 1], or auto"));
}

TEST(LdaOutcome, WarnsOfConstantFeaturesAndRefusesWhatHasNoWeights) {
  std::ostringstream out;
  std::ostringstream err;
  const Console console{out, err};
  lda::Summary summary;
  summary.termination = lda::Termination::kSolved;
  RequireUsable(summary, {"a", "b"}, console);
  EXPECT_EQ(err.str(), "");
  summary.constant_features = {1};
  RequireUsable(summary, {"a", "b"}, console);
  EXPECT_EQ(err.str(), "handcraft: warning: constant features get the weight 0: b\n");
  summary.termination = lda::Termination::kSingular;
  summary.message = "it is singular";
  summary.advice = "set shrinkage_rule";
  EXPECT_THROWS_MESSAGE(RequireUsable(summary, {}, console),
                        Error,
                        HasSubstr("no model: it is singular (give --shrinkage auto)"));
  summary.advice = "leave the column out";
  EXPECT_THROWS_MESSAGE(
      RequireUsable(summary, {}, console), Error, HasSubstr("leave the column out"));
}

}  // namespace
}  // namespace handcraft::tools
