// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/text_table.h"

#include <gtest/gtest.h>

namespace handcraft::tools {
namespace {

TEST(TextTable, AlignsWordsLeftAndNumbersRight) {
  TextTable table({"name", "count"});
  table.AddRow({"apple", "7"});
  table.AddRow({"fig", "-120.5"});
  EXPECT_EQ(table.ToText(),
            "name    count\n"
            "apple       7\n"
            "fig    -120.5\n");
}

TEST(TextTable, CountsCharactersNotBytes) {
  TextTable table({"class", "n"});
  table.AddRow({"Löffel", "1"});
  table.AddRow({"Gabel", "22"});
  EXPECT_EQ(table.ToText(),
            "class    n\n"
            "Löffel   1\n"
            "Gabel   22\n");
}

TEST(TextTable, DoesWithoutHead) {
  TextTable table;
  table.AddRow({"key", "value"});
  table.AddRow({"a", "b"});
  EXPECT_EQ(table.ToText(), "key  value\na    b\n");
}

TEST(TextTable, TreatsDashAndNanAsMissingNumbers) {
  TextTable table({"value"});
  table.AddRow({"123"});
  table.AddRow({"-"});
  table.AddRow({"nan"});
  EXPECT_EQ(table.ToText(), "value\n  123\n    -\n  nan\n");
}

// "–" takes three bytes and one column; a column of numbers and dashes stays one of numbers.
TEST(TextTable, AlignsTheLongDashAmongNumbersAndWords) {
  TextTable table({"measure", "value", "95 % interval"});
  table.AddRow({"area", "–", "–"});
  table.AddRow({"accuracy", "86.70 %", "80.40 % to 91.90 %"});
  table.AddRow({"a – b", "7", "words"});
  EXPECT_EQ(table.ToText(),
            "measure     value  95 % interval\n"
            "area            –  –\n"
            "accuracy  86.70 %  80.40 % to 91.90 %\n"
            "a – b           7  words\n");
}

TEST(TextTable, KeepsARowOnOneLine) {
  TextTable table({"class", "images"});
  table.AddRow({"a\nb\t\x1B", "3"});
  EXPECT_EQ(table.ToText(), "class       images\na\\nb\\t\\x1B       3\n");
}

TEST(TextTable, TakesShortRowsAndNone) {
  TextTable table({"a", "b"});
  table.AddRow({"1"});
  EXPECT_EQ(table.ToText(), "a  b\n1\n");
  EXPECT_EQ(TextTable().ToText(), "");
}

}  // namespace
}  // namespace handcraft::tools
