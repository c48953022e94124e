// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;

svm::Options Parse(const std::string& line) {
  CLI::App app;
  svm::Options options;
  AddSvmOptions(app, options);
  app.parse(line);
  return options;
}

TEST(SvmOptions, KeepTheTrainersDefaults) {
  EXPECT_EQ(FieldsToText(Parse("")), FieldsToText(svm::Options{}));
}

TEST(SvmOptions, AreTaken) {
  const svm::Options options = Parse(
      "--kernel poly --degree 2 --gamma 0.5 --coef0 1 --C 10 --standardize --tolerance 0.01 "
      "--scheme one-against-all");
  EXPECT_EQ(options.kernel, features::SimilarityType::kPolynomial);
  EXPECT_EQ(options.degree, 2);
  EXPECT_EQ(options.gamma, 0.5);
  EXPECT_EQ(options.coef0, 1.0);
  EXPECT_EQ(options.penalty, 10.0);
  EXPECT_TRUE(options.standardize);
  EXPECT_EQ(options.smo.tolerance, 0.01);
  EXPECT_EQ(options.scheme, features::ClassScheme::kOneAgainstAll);
  EXPECT_EQ(Parse("--kernel rbf").kernel, features::SimilarityType::kRbf);
  EXPECT_EQ(Parse("--kernel linear").kernel, features::SimilarityType::kLinear);
}

TEST(SvmOptions, RefuseWhatTheTrainerRefuses) {
  for (const char* line : {"--kernel cubic",
                           "--degree 0",
                           "--gamma -1",
                           "--coef0 -1",
                           "--C 0",
                           "--tolerance 0",
                           "--scheme all"}) {
    EXPECT_THROW(Parse(line), CLI::ValidationError) << line;
  }
  EXPECT_THROWS_MESSAGE(
      Parse("--C 0"), CLI::ValidationError, HasSubstr("0 given; it must be above 0"));
}

TEST(SvmOutcome, RefusesWhatDidNotConverge) {
  svm::Summary summary;
  EXPECT_THROWS_MESSAGE(RequireUsable(summary), Error, HasSubstr("no model: the trainer was not"));
  summary.termination = svm::Termination::kConverged;
  RequireUsable(summary);
}

}  // namespace
}  // namespace handcraft::tools
