// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_entries.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/structured_text/toml_file.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::array<std::string_view, 2> kKeys = {"speed", "colour"};

void CheckColour(const Setting& setting) {
  if (setting.key == "colour" && setting.value != "red") {
    throw Error({.kind = Error::Kind::kUsage, .reason = "colour is not red", .remedy = "red"});
  }
}

constexpr SettingRules kRules = {.keys = kKeys, .check = &CheckColour};

// Calls use(top of the file).
template <class Use>
auto WithToml(const std::string& text, const Use& use) {
  const toml::table parsed = ParseToml(text, "s.toml");
  return use(TomlTable("s.toml", parsed, ""));
}

TEST(StudyEntries, ValuesMayBeGivenBySize) {
  const std::string text = "n = { small = 2, full = 70 }\nm = 5\n";
  WithToml(text, [](const TomlTable& top) {
    EXPECT_EQ(ParseWhole(top, "n", StudySize::kSmall, 1), 2);
    EXPECT_EQ(ParseWhole(top, "n", StudySize::kFull, 1), 70);
    EXPECT_EQ(ParseWhole(top, "m", StudySize::kFull, 1), 5);
    EXPECT_THROWS_MESSAGE(static_cast<void>(ParseWhole(top, "m", StudySize::kSmall, 6)),
                          Error,
                          HasSubstr("s.toml:2: m must be a whole number from 6"));
  });
}

TEST(StudyEntries, SettingsComeInTheOrderOfTheRules) {
  const auto settings =
      WithToml("[settings]\ncolour = \"red\"\nspeed = 0.5\n",
               [](const auto& top) { return ParseStudySettings(top, StudySize::kSmall, kRules); });
  EXPECT_THAT(settings, ElementsAre(Setting{"speed", "0.5"}, Setting{"colour", "red"}));
  EXPECT_TRUE(WithToml("", [](const auto& top) {
    return ParseStudySettings(top, StudySize::kSmall, kRules).empty();
  }));
}

TEST(StudyEntries, ASettingThatBreaksItsRuleIsToldWithItsLine) {
  const auto parse = [](const TomlTable& top) {
    return ParseStudySettings(top, StudySize::kSmall, kRules);
  };
  EXPECT_THROWS_MESSAGE(WithToml("[settings]\n\ncolour = \"blue\"\n", parse),
                        Error,
                        HasSubstr("s.toml:3: colour is not red (red)"));
  EXPECT_THROWS_MESSAGE(WithToml("[settings]\nsize = 1\n", parse), Error, HasSubstr("size"));
}

TEST(StudyEntries, MethodsHaveNamesOfTheirOwn) {
  const auto parse = [](const TomlTable& top) {
    return ParseMethods(top, StudySize::kSmall, kRules);
  };
  const auto methods = WithToml("[[method]]\nname = \"a\"\nspeed = 1\n", parse);
  ASSERT_EQ(methods.size(), 1U);
  EXPECT_THAT(methods[0].settings, ElementsAre(Setting{"speed", "1"}));
  EXPECT_THROWS_MESSAGE(WithToml("[[method]]\nname = \"a\"\n[[method]]\nname = \"a\"\n", parse),
                        Error,
                        HasSubstr("two methods are named \"a\""));
  EXPECT_THROWS_MESSAGE(
      WithToml("[[method]]\nname = \"a/b\"\n", parse), Error, HasSubstr("name is \"a/b\""));
  EXPECT_THROWS_MESSAGE(WithToml("", parse), Error, HasSubstr("at least one [[method]]"));
}

TEST(StudyEntries, AFactorIsAListThatNoMethodSets) {
  const std::array<Method, 1> methods = {Method{"a", {{"colour", "red"}}}};
  const auto parse = [&](const TomlTable& top) {
    return ParseGrid(top, StudySize::kSmall, kRules, methods);
  };
  const auto factors = WithToml("[grid]\nspeed = [1, 2]\n", parse);
  ASSERT_EQ(factors.size(), 1U);
  EXPECT_THAT(factors[0].values, ElementsAre("1", "2"));
  EXPECT_THROWS_MESSAGE(
      WithToml("[grid]\nspeed = [1, 1]\n", parse), Error, HasSubstr("speed has 1 twice"));
  EXPECT_THROWS_MESSAGE(
      WithToml("[grid]\nspeed = []\n", parse), Error, HasSubstr("speed is no list of values"));
  EXPECT_THROWS_MESSAGE(WithToml("[grid]\ncolour = [\"red\"]\n", parse),
                        Error,
                        HasSubstr("colour is set by the method \"a\" too"));
}

TEST(StudyEntries, CombinationsAreNamedSoThatTheyCanBeFiles) {
  const std::array<Factor, 2> factors = {Factor{"speed", {"1", "2"}},
                                         Factor{"colour", {"a b/c,d"}}};
  const auto combinations = Combine(factors);
  ASSERT_EQ(combinations.size(), 2U);
  EXPECT_EQ(CombinationId("m", combinations[1]), "m,speed=2,colour=a+b+c+d");
}

}  // namespace
}  // namespace handcraft::experiments
