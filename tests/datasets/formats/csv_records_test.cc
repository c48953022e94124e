// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/csv_records.h"

#include <fstream>
#include <string>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using Record = std::vector<std::string>;

struct Parsed {
  std::vector<Record> records;
  std::vector<std::size_t> lines;
};

Parsed Parse(std::string_view text) {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder / "t.csv", std::ios::binary) << text;
  CsvRecords reader(folder / "t.csv");
  Parsed parsed;
  std::vector<std::string_view> fields;
  while (reader.Next(fields)) {
    parsed.records.emplace_back(fields.begin(), fields.end());
    parsed.lines.push_back(reader.line());
  }
  return parsed;
}

TEST(CsvRecords, SplitsPlainLines) {
  const Parsed parsed = Parse("a,b\n1, 2 \n,\n");
  EXPECT_EQ(parsed.records, (std::vector<Record>{{"a", "b"}, {"1", " 2 "}, {"", ""}}));
  EXPECT_EQ(parsed.lines, (std::vector<std::size_t>{1, 2, 3}));
}

TEST(CsvRecords, TakesEveryLineEndAndNone) {
  const std::vector<Record> expected = {{"a", "b"}, {"c", "d"}};
  for (const char* text : {"a,b\nc,d", "a,b\nc,d\n", "a,b\r\nc,d\r\n", "a,b\r\nc,d\r"}) {
    EXPECT_EQ(Parse(text).records, expected) << text;
    EXPECT_EQ(Parse(std::string("\xEF\xBB\xBF") + text).records, expected) << "with mark " << text;
  }
}

TEST(CsvRecords, SkipsEmptyLinesButCountsThem) {
  const Parsed parsed = Parse("\n\na\n\r\n\nb\n\n");
  EXPECT_EQ(parsed.records, (std::vector<Record>{{"a"}, {"b"}}));
  EXPECT_EQ(parsed.lines, (std::vector<std::size_t>{3, 6}));
}

TEST(CsvRecords, UnderstandsQuotes) {
  const Parsed parsed =
      Parse("\"a,b\",\"say \"\"yes\"\"\",\"\"\n\"two\nlines\",x,\"\"\"\"\nlast\n");
  EXPECT_EQ(parsed.records,
            (std::vector<Record>{{"a,b", "say \"yes\"", ""}, {"two\nlines", "x", "\""}, {"last"}}));
  EXPECT_EQ(parsed.lines, (std::vector<std::size_t>{1, 2, 4}));
}

TEST(CsvRecords, FindsNothingInAnEmptyFile) {
  EXPECT_TRUE(Parse("").records.empty());
  EXPECT_TRUE(Parse("\n\n").records.empty());
}

TEST(CsvRecords, NamesTheLineOfABadQuote) {
  EXPECT_THROWS_MESSAGE(
      Parse("a\n\"b"), Error, HasSubstr("t.csv:2: a quote is opened and never closed"));
  EXPECT_THROWS_MESSAGE(
      Parse("a,\"b\"c\n"), Error, HasSubstr("t.csv:1: field 2 goes on after its closing quote"));
}

// Law: what CsvField writes, CsvRecords reads.
TEST(CsvField, ComesBackUnchanged) {
  const std::vector<std::string> alphabet = {"a", "b", ",", "\"", "\r", "\n", " ", "é"};
  Rng rng(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<Record> records(3, Record(2));
    std::string text;
    for (Record& record : records) {
      for (std::string& field : record) {
        for (std::uint64_t length = rng.UniformInt(6); length > 0; --length) {
          field += alphabet[rng.UniformInt(alphabet.size())];
        }
      }
      record.back() += '.';  // a record of empty fields alone cannot be told from an empty line
      text += CsvField(record[0]) + "," + CsvField(record[1]) + "\n";
    }
    EXPECT_EQ(Parse(text).records, records) << text;
  }
}

TEST(CsvField, QuotesOnlyWhereItMust) {
  EXPECT_EQ(CsvField("plain text"), "plain text");
  EXPECT_EQ(CsvField("a,b"), "\"a,b\"");
  EXPECT_EQ(CsvField("\""), "\"\"\"\"");
}

}  // namespace
}  // namespace handcraft::datasets
