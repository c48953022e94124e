// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/help_formatter.h"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace handcraft::tools {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class HelpFormatterTest : public ::testing::Test {
 protected:
  HelpFormatterTest() { app_.formatter(std::make_shared<HelpFormatter>()); }

  CLI::App app_;
  double number_ = 0.5;
  std::vector<std::string> words_;
};

TEST_F(HelpFormatterTest, PutsKindBesideAndDefaultBehind) {
  app_.add_option("--number", number_, "A number")
      ->type_name("NUMBER")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  EXPECT_THAT(app_.help(), HasSubstr("  --number NUMBER               A number [0.5]\n"));
}

TEST_F(HelpFormatterTest, MarksRequiredOptionsAndLists) {
  app_.add_option("--out", number_, "Where")->required();
  app_.add_option("INPUT", words_, "What")->required();
  EXPECT_THAT(app_.help(), HasSubstr("Where (required)\n"));
  EXPECT_THAT(app_.help(), ContainsRegex("INPUT\\.\\.\\. +What\n"));
}

TEST_F(HelpFormatterTest, WrapsLongDescriptionsBetweenWords) {
  app_.add_option("--long", number_, std::string(40, 'a') + " " + std::string(40, 'b'));
  EXPECT_THAT(app_.help(), HasSubstr("a\n                                b"));
}

TEST_F(HelpFormatterTest, ShowsNoDefaultWhereTheValueMayBeLeftOut) {
  std::string file;
  app_.add_option("--json", file, "To a file")->expected(0, 1)->default_str("-");
  EXPECT_THAT(app_.help(), HasSubstr("To a file\n"));
}

TEST_F(HelpFormatterTest, ListsCommandsAsCommands) {
  app_.add_subcommand("walk", std::string(40, 'a') + " " + std::string(40, 'b'));
  EXPECT_THAT(app_.help(), HasSubstr("\n\nCommands:\n  walk "));
  EXPECT_THAT(app_.help(), HasSubstr("a\n                                b"));
}

TEST_F(HelpFormatterTest, SetsGroupsOneLineApart) {
  app_.add_option("--number", number_, "A number")->group("Numbers");
  EXPECT_THAT(app_.help(), HasSubstr("exit\n\nNumbers:\n"));
}

TEST_F(HelpFormatterTest, KeepsFlagsBare) {
  bool flag = false;
  app_.add_flag("--flag", flag, "On");
  EXPECT_THAT(app_.help(), ContainsRegex("--flag +On\n"));
  EXPECT_THAT(app_.help(), Not(HasSubstr("BOOLEAN")));
}

}  // namespace
}  // namespace handcraft::tools
