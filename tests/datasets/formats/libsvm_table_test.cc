// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/libsvm_table.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LibsvmTableTest : public ::testing::Test {
 protected:
  std::filesystem::path Write(const std::string& text) {
    std::ofstream(folder_ / "t.libsvm") << text;
    return folder_ / "t.libsvm";
  }
  void ExpectRefused(const std::string& text, const std::string& message) {
    EXPECT_THROWS_MESSAGE(ReadLibsvmTable(Write(text)), Error, HasSubstr(message));
  }
  const handcraft::testing::TemporaryDirectory folder_;
};

TEST_F(LibsvmTableTest, ReadsSparseSamples) {
  const Table table = ReadLibsvmTable(Write("+1 1:0.5 3:-2e1 \n\n-1\t2:7\r\n2.50\n"));
  EXPECT_EQ(table.num_rows, 3U);
  EXPECT_THAT(table.columns, ElementsAre("1", "2", "3"));
  EXPECT_THAT(table.labels, ElementsAre("1", "-1", "2.5"));
  EXPECT_THAT(table.values, ElementsAre(0.5, 0, -20, 0, 7, 0, 0, 0, 0));
  EXPECT_EQ(table.label_column, "label");
}

TEST_F(LibsvmTableTest, HasAsManyColumnsAsWanted) {
  EXPECT_EQ(ReadLibsvmTable(Write("1 2:1"), 5).columns.size(), 5U);
  EXPECT_EQ(ReadLibsvmTable(Write("1 2:1"), 1).columns.size(), 2U);
}

TEST_F(LibsvmTableTest, IsWhatReadTableReads) {
  const Table table = ReadTable(Write("1 1:3\n2 1:4\n"), "");
  EXPECT_THAT(table.labels, ElementsAre("1", "2"));
  EXPECT_THAT(table.values, ElementsAre(3, 4));
  EXPECT_EQ(ReadTable(Write("1 1:3\n"), "", {"1", "2"}).columns.size(), 2U);
  EXPECT_THROWS_MESSAGE(
      ReadTable(Write("1 1:3\n"), "class"), Error, HasSubstr("no column 'class'"));
  EXPECT_THROWS_MESSAGE(ReadTable(Write("\n\n"), ""), Error, HasSubstr("no row of numbers"));
}

TEST_F(LibsvmTableTest, IsKnownByItsName) {
  EXPECT_TRUE(IsLibsvmText("a/b.libsvm"));
  EXPECT_TRUE(IsLibsvmText("b.svm"));
  EXPECT_FALSE(IsLibsvmText("libsvm"));
}

TEST_F(LibsvmTableTest, NamesTheLineOfWhatIsWrong) {
  ExpectRefused("1 1:2\nyes 1:2\n", "t.libsvm:2: 'yes' where a label, a finite number, is due");
  ExpectRefused("1 1\n", ":1: '1' where index:value is due");
  ExpectRefused("1 0:1\n", "'0:1': an index is a whole number from 1 to 1000000");
  ExpectRefused("1 1000001:1\n", "an index is a whole number from 1 to 1000000");
  ExpectRefused("1 x:1\n", "'x:1': an index is a whole number");
  ExpectRefused("1 2:1 2:3\n", "'2:3': indices rise within a line");
  ExpectRefused("1 2:nan\n", "'nan' where a value, a finite number, is due");
  ExpectRefused("1 2:\n", "'' where a value, a finite number, is due");
  ExpectRefused("inf 2:1\n", "'inf' where a label");
}

TEST_F(LibsvmTableTest, RefusesATableThatWouldFillTheMemory) {
  std::string text = "1 1000000:1\n";
  for (int i = 0; i < 300; ++i) text += "1\n";
  ExpectRefused(text, "301 rows of 1000000 columns are more than 2^28 numbers");
}

}  // namespace
}  // namespace handcraft::datasets
