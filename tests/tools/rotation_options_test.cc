// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/rotation_options.h"

#include <gtest/gtest.h>

namespace handcraft::tools {
namespace {

features::RotationRule Parsed(const std::string& line) {
  CLI::App app;
  RotationArguments arguments;
  AddRotationOptions(app, arguments);
  app.parse(line);
  return RuleOf(arguments);
}

TEST(RotationOptions, AreTheLibrarysDefaults) {
  const features::RotationRule rule = Parsed("");
  const features::RotationRule expected;
  EXPECT_EQ(rule.moments, expected.moments);
  EXPECT_EQ(rule.num_candidates, expected.num_candidates);
  EXPECT_EQ(rule.angle_weight, expected.angle_weight);
}

TEST(RotationOptions, TakeThePrintedRule) {
  const features::RotationRule rule = Parsed("--moments printed --candidates 6 --angle-weight 0");
  EXPECT_EQ(rule.moments, features::ComparedMoments::kPrinted);
  EXPECT_EQ(rule.num_candidates, 6U);
  EXPECT_EQ(rule.angle_weight, 0.0);
  EXPECT_EQ(Parsed("--moments scale_free").moments, features::ComparedMoments::kScaleFree);
}

TEST(RotationOptions, RefuseWhatTheLibraryRefuses) {
  EXPECT_THROW(static_cast<void>(Parsed("--candidates 65")), CLI::ParseError);
  EXPECT_THROW(static_cast<void>(Parsed("--angle-weight -1")), CLI::ParseError);
  EXPECT_THROW(static_cast<void>(Parsed("--moments few")), CLI::ParseError);
}

}  // namespace
}  // namespace handcraft::tools
