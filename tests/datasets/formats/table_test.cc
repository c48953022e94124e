// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/table.h"

#include <fstream>
#include <limits>
#include <string>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Table ReadText(std::string_view text, const std::string& label_column = "") {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder / "t.csv", std::ios::binary) << text;
  return ReadTable(folder / "t.csv", label_column);
}

Table ReadMatrix(const std::vector<double>& values, std::size_t rows, const std::string& label) {
  const testing::TemporaryDirectory folder;
  WriteNpy(folder / "t.npy", values.data(), rows, values.size() / rows);
  return ReadTable(folder / "t.npy", label);
}

TEST(ReadTable, ReadsCsvWithALabelInTheMiddle) {
  const Table table = ReadText("x, kind ,y\n1,cat,-2.5\n+3e2,\"a dog\", 4 \r\n", "kind");
  EXPECT_THAT(table.columns, ElementsAre("x", "y"));
  EXPECT_THAT(table.values, ElementsAre(1, -2.5, 300, 4));
  EXPECT_EQ(table.num_rows, 2U);
  EXPECT_EQ(table.label_column, "kind");
  EXPECT_THAT(table.labels, ElementsAre("cat", "a dog"));
}

TEST(ReadTable, PassesOverWhatIsNotWanted) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "t.csv", "id,x,kind,y\nfirst,1,a,\nnan,2,b,?\n");
  const Table table = ReadTable(folder / "t.csv", "kind", {"x", "z"});
  EXPECT_THAT(table.columns, ElementsAre("x"));
  EXPECT_THAT(table.values, ElementsAre(1, 2));
  EXPECT_THAT(table.labels, ElementsAre("a", "b"));
}

// Latin-1, UTF-16 and binary files, with the line of the first byte that is not UTF-8.
TEST(ReadTable, RefusesWhatIsNotUtf8) {
  const std::string reason = "not UTF-8 text: a byte that cannot stand there";
  EXPECT_THROWS_MESSAGE(ReadText("a,b\n1,2\ngr\xF6\xDF,3\n"), Error, HasSubstr(":3: " + reason));
  EXPECT_THROWS_MESSAGE(ReadText(std::string("\xFF\xFE") + "a"), Error, HasSubstr(":1: " + reason));
  EXPECT_THROWS_MESSAGE(ReadText(std::string("a\0b", 3)), Error, HasSubstr(":1: " + reason));
}

TEST(ReadTable, ReadsFeaturesAlone) {
  const Table table = ReadText("x,y\n1,2\n");
  EXPECT_THAT(table.columns, ElementsAre("x", "y"));
  EXPECT_THAT(table.labels, IsEmpty());
}

TEST(ReadTable, ReadsEveryBitOfANumber) {
  Rng rng(11);
  std::string text = "x\n";
  std::vector<double> values = {std::numeric_limits<double>::denorm_min(),
                                -std::numeric_limits<double>::max(),
                                -0.0,
                                9007199254740993.0};
  for (int i = 0; i < 1000; ++i) values.push_back(rng.Normal() * 1e-30);
  for (const double value : values) text += NumberToText(value) + "\n";
  EXPECT_EQ(ReadText(text).values, values);
}

TEST(ReadTable, ReadsNpyWithALabelByNumber) {
  const Table last = ReadMatrix({1, 2, 0, 3, 4, 1}, 2, "-1");
  EXPECT_THAT(last.columns, ElementsAre("0", "1"));
  EXPECT_THAT(last.values, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(last.labels, ElementsAre("0", "1"));
  EXPECT_EQ(last.label_column, "2");
  const Table first = ReadMatrix({1.5, 2, 0, -3, 4, 1}, 2, "0");
  EXPECT_THAT(first.columns, ElementsAre("1", "2"));
  EXPECT_THAT(first.labels, ElementsAre("1.5", "-3"));
  EXPECT_THAT(ReadMatrix({1, 2, 3, 4}, 2, "").values, ElementsAre(1, 2, 3, 4));
}

TEST(ReadTable, KnowsNpyByItsContent) {
  const testing::TemporaryDirectory folder;
  const double value = 7;
  WriteNpy(folder / "table", &value, 1, 1);
  EXPECT_THAT(ReadTable(folder / "table", "").values, ElementsAre(7));
  WriteFileAtomically(folder / "t.npy", "x\n1\n");
  EXPECT_THROWS_MESSAGE(ReadTable(folder / "t.npy", ""), Error, HasSubstr("not an NPY file"));
}

TEST(ReadTable, NamesTheLineAndTheColumn) {
  const std::string start = "x,y\n1,2\n\n";
  EXPECT_THROWS_MESSAGE(
      ReadText(start + "1,2,3\n"), Error, HasSubstr("t.csv:4: 3 fields; the first line has 2"));
  EXPECT_THROWS_MESSAGE(
      ReadText(start + "1,two\n"), Error, HasSubstr("t.csv:4: column 'y': 'two' where a number"));
  for (const char* word : {"1.0.0", "0x10", "1,5", "--1", "1e", "1 2"}) {
    EXPECT_THROW(static_cast<void>(ReadText(start + "1," + word + "\n")), Error) << word;
  }
  EXPECT_THROWS_MESSAGE(ReadText(start + "1,\n"), Error, HasSubstr("'y': nothing where a number"));
  for (const char* word : {"nan", "NaN", "inf", "-Infinity"}) {
    EXPECT_THROWS_MESSAGE(
        ReadText(start + word + ",1\n"), Error, HasSubstr("is not a finite number"));
  }
  EXPECT_THROWS_MESSAGE(ReadText(start + "1e999,1\n"), Error, HasSubstr("'x': '1e999'"));
  EXPECT_THROWS_MESSAGE(
      ReadText(start + "1," + std::string(99, 'z') + "\n"), Error, HasSubstr("zzz…'"));
}

TEST(ReadTable, NamesWhatIsWrongWithTheHeader) {
  EXPECT_THROWS_MESSAGE(ReadText(""), Error, HasSubstr("t.csv: the file is empty"));
  EXPECT_THROWS_MESSAGE(ReadText("x,y\n"), Error, HasSubstr("t.csv: no row of numbers"));
  EXPECT_THROWS_MESSAGE(ReadText("x,x\n1,2\n"), Error, HasSubstr("t.csv:1: column 'x' appears"));
  EXPECT_THROWS_MESSAGE(ReadText("x,\n1,2\n"), Error, HasSubstr("column 2 has no name"));
  EXPECT_THROWS_MESSAGE(ReadText("x;y\n1;2\n"), Error, HasSubstr("separate fields by commas"));
  EXPECT_THROWS_MESSAGE(ReadText("y\n1\n", "y"), Error, HasSubstr("no column of numbers"));
  EXPECT_THROWS_MESSAGE(ReadTable("no/such.csv", ""), Error, HasSubstr("No such file"));
}

TEST(ReadTable, ListsTheColumnsWhenTheLabelIsNone) {
  EXPECT_THROWS_MESSAGE(
      ReadText("x,y\n1,2\n", "z"), Error, HasSubstr("no column 'z'; there are: 'x', 'y'"));
  for (const char* label : {"3", "-2", "x", "1.0"}) {
    EXPECT_THROWS_MESSAGE(
        ReadMatrix({1, 2, 3}, 1, label), Error, HasSubstr("numbers from 0 to 2, -1 is the last"));
  }
  EXPECT_THROWS_MESSAGE(ReadText("x,y\n1,\n", "y"), Error, HasSubstr(":2: no label in column 'y'"));
}

TEST(ToBinaryLabels, PutsTheSmallerFirst) {
  const auto labels = [](std::vector<std::string> texts) {
    Table table;
    table.labels = std::move(texts);
    return ToBinaryLabels(table, "t.csv");
  };
  const BinaryLabels numbers = labels({"10", "9", "10"});
  EXPECT_EQ(numbers.negative, "9");
  EXPECT_EQ(numbers.positive, "10");
  EXPECT_THAT(numbers.values, ElementsAre(1, 0, 1));
  EXPECT_EQ(labels({"1", "-1"}).negative, "-1");
  EXPECT_EQ(labels({"good", "bad"}).negative, "bad");
  EXPECT_EQ(labels({"nan", "1"}).negative, "1") << "numbers before words";
}

TEST(ToBinaryLabels, RefusesOneAndThree) {
  Table table;
  table.label_column = "kind";
  EXPECT_THROWS_MESSAGE(
      ToBinaryLabels(table, "t.csv"), Error, HasSubstr("t.csv: column 'kind' holds 0 labels; "));
  table.labels = {"a", "a"};
  EXPECT_THROWS_MESSAGE(ToBinaryLabels(table, "t.csv"), Error, HasSubstr("1 labels: 'a'; exactly"));
  for (int i = 0; i < 30; ++i) table.labels.push_back(std::to_string(i));
  EXPECT_THROWS_MESSAGE(
      ToBinaryLabels(table, "t.csv"), Error, HasSubstr("'19', … (31 in all); exactly two are due"));
}

TEST(ToClassLabels, AreNumberedInTheOrderOfTheirFirstRows) {
  Table table;
  table.labels = {"mug", "10", "mug", "9", "10"};
  const ClassLabels labels = ToClassLabels(table, "t.csv");
  EXPECT_THAT(labels.names, ElementsAre("mug", "10", "9"));
  EXPECT_THAT(labels.values, ElementsAre(0, 1, 0, 2, 1));
}

TEST(ToClassLabels, RefusesOne) {
  Table table;
  table.label_column = "kind";
  table.labels = {"a", "a"};
  EXPECT_THROWS_MESSAGE(ToClassLabels(table, "t.csv"),
                        Error,
                        HasSubstr("t.csv: column 'kind' holds 1 labels: 'a'; at least two"));
}

}  // namespace
}  // namespace handcraft::datasets
