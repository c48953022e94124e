// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/number_option.h"

#include <gtest/gtest.h>

#include "lib/core/option_rules.h"

namespace handcraft::tools {
namespace {

struct Options {
  double share = 0.5;
  int steps = 3;
  std::size_t draws = 10;
  void Validate() const {
    RequireOption(share > 0.0 && share <= 1.0, "Options.share", share, "in (0, 1]");
    RequireOption(steps >= 1, "Options.steps", steps, "1 or more");
    RequireOption(draws >= 2, "Options.draws", draws, "2 or more");
  }
};

// Parses the line into `options`; what is wrong with it, empty if nothing.
std::string Parse(const std::string& line, Options& options) {
  std::uint64_t seed = 0;
  CLI::App app;
  AddNumber(app, "--share", options, &Options::share, "");
  AddNumber(app, "--steps", options, &Options::steps, "");
  AddNumber(app, "--draws", options, &Options::draws, "");
  AddNumber(app, "--threads", options.steps, IntegerWithin(1, 8), "");
  AddNumber(app, "--seed", seed, AnyNumber<std::uint64_t>(), "");
  try {
    app.parse(line);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "";
}

std::string Refusal(const std::string& line) {
  Options options;
  return Parse(line, options);
}

TEST(AddNumber, TakesWhatTheLibraryTakes) {
  Options options;
  EXPECT_EQ(Parse("--share 1e-1 --steps 7 --draws 2", options), "");
  EXPECT_EQ(options.share, 0.1);
  EXPECT_EQ(options.steps, 7);
  EXPECT_EQ(options.draws, 2U);
}

TEST(AddNumber, SaysTheRuleOfTheLibraryWithTheNameOfTheOption) {
  EXPECT_EQ(Refusal("--share 0"), "--share: 0 given; it must be in (0, 1]");
  EXPECT_EQ(Refusal("--share nan"), "--share: nan given; it must be in (0, 1]");
  EXPECT_EQ(Refusal("--steps -2"), "--steps: -2 given; it must be 1 or more");
  EXPECT_EQ(Refusal("--draws -2"), "--draws: -2 given; it must be 2 or more");
}

TEST(AddNumber, RefusesWhatIsNoNumberOfTheKind) {
  EXPECT_EQ(Refusal("--share x"), "--share: x given; it must be a number");
  EXPECT_EQ(Refusal("--share 1x"), "--share: 1x given; it must be a number");
  EXPECT_EQ(Refusal("--steps 1.5"), "--steps: 1.5 given; it must be a whole number");
  EXPECT_EQ(Refusal("--draws 0x10"), "--draws: 0x10 given; it must be a whole number");
  EXPECT_EQ(Refusal("--seed -1"), "--seed: -1 given; it must be 0 or more");
}

TEST(AddNumber, RefusesWhatItsTypeCannotHold) {
  EXPECT_EQ(Refusal("--steps 3000000000"),
            "--steps: 3000000000 given; it must be from -2147483648 to 2147483647");
  EXPECT_EQ(Refusal("--steps -3000000000"), "--steps: -3000000000 given; it must be 1 or more");
  EXPECT_EQ(Refusal("--threads 99999999999999"),
            "--threads: 99999999999999 given; it must be from 1 to 8");
  EXPECT_EQ(Refusal("--seed 99999999999999999999"),
            "--seed: 99999999999999999999 given; it must be from 0 to 18446744073709551615");
}

TEST(AddNumber, NamesTheKindOfTheMissingValue) {
  EXPECT_EQ(Refusal("--share"), "--share: 1 required NUMBER missing");
  EXPECT_EQ(Refusal("--draws"), "--draws: 1 required INT missing");
}

TEST(AddNumber, ReadsDecimalsAlone) {
  Options options;
  EXPECT_EQ(Parse("--steps 010", options), "");
  EXPECT_EQ(options.steps, 10);
}

TEST(IntegerWithin, TakesItsBounds) {
  EXPECT_EQ(Refusal("--threads 1"), "");
  EXPECT_EQ(Refusal("--threads 8"), "");
  EXPECT_EQ(Refusal("--threads 9"), "--threads: 9 given; it must be from 1 to 8");
}

TEST(RuleOf, IsWhatFollowsMustBe) {
  EXPECT_EQ(RuleOf(Error({.reason = "Options.a is 0: it must be > 0"})), "> 0");
  EXPECT_EQ(RuleOf(Error({.reason = "something else"})), "something else");
}

}  // namespace
}  // namespace handcraft::tools
