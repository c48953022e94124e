// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/structured_text/toml_table.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/structured_text/toml_file.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class TomlTableTest : public ::testing::Test {
 protected:
  toml::table parsed_ = ParseToml(
      "name = \"a\"\ncount = 3\nempty = \"\"\n[inner]\nshare = 0.5\n[[item]]\nx = 1\n[[item]]\nx = "
      "2\n",
      "f.toml");
  TomlTable table_{"f.toml", parsed_, ""};
};

TEST_F(TomlTableTest, ReadsTextsNumbersAndTables) {
  EXPECT_TRUE(table_.Has("name"));
  EXPECT_FALSE(table_.Has("nothing"));
  EXPECT_EQ(table_.Text("name"), "a");
  EXPECT_EQ(table_.Number("count", 0, 10), 3.0);
  EXPECT_EQ(table_.Table("inner").Number("share", 0, 1), 0.5);
  const std::vector<TomlTable> items = table_.Tables("item");
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[1].Number("x", 0, 5), 2.0);
  EXPECT_TRUE(table_.Tables("nothing").empty());
}

TEST_F(TomlTableTest, NamesFileLineAndKeyOfWhatIsWrong) {
  EXPECT_THROWS_MESSAGE(table_.Text("count"), Error, HasSubstr("f.toml:2: count is no text"));
  EXPECT_THROWS_MESSAGE(table_.Text("empty"), Error, HasSubstr("f.toml:3: empty is no text"));
  EXPECT_THROWS_MESSAGE(table_.Text("nothing"), Error, HasSubstr("nothing is missing"));
  EXPECT_THROWS_MESSAGE(
      table_.Number("count", 5, 10), Error, HasSubstr("count must be a number from 5 to 10"));
  EXPECT_THROWS_MESSAGE(table_.Number("name", 0, 1), Error, HasSubstr("f.toml:1"));
  EXPECT_THROWS_MESSAGE(table_.Table("name"), Error, HasSubstr("name is no table"));
  EXPECT_THROWS_MESSAGE(table_.Tables("name"), Error, HasSubstr("[[name]]"));
  EXPECT_THROWS_MESSAGE(
      table_.Table("inner").Text("share"), Error, HasSubstr("f.toml:5: inner share is no text"));
}

TEST_F(TomlTableTest, RefusesUnknownKeysWithTheirLine) {
  constexpr std::array<std::string_view, 4> kKeys = {"name", "count", "empty", "item"};
  EXPECT_THROWS_MESSAGE(table_.AllowOnly(kKeys),
                        Error,
                        AllOf(HasSubstr("f.toml:4: \"inner\" is no key of this file"),
                              HasSubstr("there are: name, count, empty, item")));
}

}  // namespace
}  // namespace handcraft
