// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/table_command.h"

#include <gtest/gtest.h>

namespace handcraft::tools {
namespace {

TEST(AddTableCommand, TakesWhatEveryTrainerOnTablesTakes) {
  CLI::App app;
  TableArguments arguments;
  const CLI::App* command = AddTableCommand(app, "ridge", "Fits a ridge", arguments);
  EXPECT_EQ(command->get_name(), "ridge");
  app.parse("ridge t.csv --label y --out m --json");
  EXPECT_EQ(arguments.table, "t.csv");
  EXPECT_EQ(arguments.label, "y");
  EXPECT_EQ(arguments.out, "m");
  EXPECT_EQ(arguments.name, "ridge");
  EXPECT_TRUE(arguments.json);
}

TEST(AddTableCommand, NeedsATableAndAFileForAName) {
  for (const char* line : {"ridge", "ridge t.csv --name mine"}) {
    CLI::App app;
    TableArguments arguments;
    static_cast<void>(AddTableCommand(app, "ridge", "Fits a ridge", arguments));
    EXPECT_THROW(app.parse(line), CLI::ParseError) << line;
  }
}

}  // namespace
}  // namespace handcraft::tools
