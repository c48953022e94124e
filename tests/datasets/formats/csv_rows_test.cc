// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/csv_rows.h"

#include <array>
#include <stdexcept>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr std::array<std::string_view, 2> kColumns = {"name", "size_m"};

class CsvRowsTest : public ::testing::Test {
 protected:
  [[nodiscard]] CsvRows Open(std::string_view text) const {
    WriteFileAtomically(folder_ / "rows.csv", text);
    return CsvRows(folder_ / "rows.csv", kColumns);
  }

  // Reads the number of the first row.
  [[nodiscard]] double NumberOf(const std::string& field) const {
    CsvRows rows = Open("name,size_m\na," + field + "\n");
    EXPECT_TRUE(rows.Next());
    return rows.Number(1);
  }

  TemporaryDirectory folder_;
};

TEST_F(CsvRowsTest, ReadsColumnsInAnyOrderAndPassesOverOthers) {
  CsvRows rows = Open("\xEF\xBB\xBFsize_m,note,name\r\n1.5,x,mug\r\n\r\n-2e-3,,\"tea, cup\"\r\n");
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Text(0), "mug");
  EXPECT_EQ(rows.Number(1), 1.5);
  EXPECT_EQ(rows.line(), 2U);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Required(0), "tea, cup");
  EXPECT_EQ(rows.Number(1), -0.002);
  EXPECT_EQ(rows.line(), 4U);
  EXPECT_FALSE(rows.Next());
  EXPECT_FALSE(rows.Next());
}

TEST_F(CsvRowsTest, NamesWhatIsWrongWithTheFirstLine) {
  EXPECT_THROWS_MESSAGE(Open(""), Error, HasSubstr("rows.csv: the file is empty"));
  EXPECT_THROWS_MESSAGE(
      Open("name,size\n"),
      Error,
      HasSubstr("rows.csv:1: no column 'size_m' (the first line names the columns: name,size_m)"));
  EXPECT_THROWS_MESSAGE(
      Open("name,size_m,name\n"), Error, HasSubstr(":1: column 'name' appears twice"));
  EXPECT_THROWS_MESSAGE(Open("name,size_m\n\xFF\xFE"), Error, HasSubstr(":2: not UTF-8 text"));
  EXPECT_THROWS_MESSAGE(CsvRows("no/such", kColumns), Error, HasSubstr("No such file"));
}

TEST_F(CsvRowsTest, NamesTheLineOfABadRow) {
  CsvRows rows = Open("name,size_m\na,1\nb\n");
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(rows.Next()), Error, HasSubstr(":3: 1 fields; the first line has 2"));
  CsvRows gap = Open("name,size_m\n,1\n");
  ASSERT_TRUE(gap.Next());
  EXPECT_EQ(gap.Text(0), "");
  EXPECT_THROWS_MESSAGE(static_cast<void>(gap.Required(0)), Error, HasSubstr(":2: no name given"));
  EXPECT_THROW(static_cast<void>(gap.Text(2)), std::logic_error);
}

TEST_F(CsvRowsTest, TakesFiniteNumbersAlone) {
  EXPECT_EQ(NumberOf(" 12 "), 12.0);
  EXPECT_THROWS_MESSAGE(
      NumberOf(""), Error, HasSubstr(":2: column 'size_m': nothing where a number is due"));
  for (const char* bad : {"1.5m", "0x10", "1 2", "1;5", "- 1", "e5", "one", "1e999"}) {
    EXPECT_THROWS_MESSAGE(
        NumberOf(bad), Error, HasSubstr("'" + std::string(bad) + "' where a number is due"));
  }
  for (const char* bad : {"nan", "inf", "-inf"}) {
    EXPECT_THROWS_MESSAGE(NumberOf(bad), Error, HasSubstr("is not a finite number"));
  }
}

TEST_F(CsvRowsTest, DoesWithoutOptionalColumns) {
  constexpr std::array<std::string_view, 2> kOptional = {"note", "weight_kg"};
  WriteFileAtomically(folder_ / "rows.csv", "weight_kg,size_m,name\n0.5,1,mug\n,1,cup\n");
  CsvRows rows(folder_ / "rows.csv", kColumns, kOptional);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(rows.Text(2), "");
  EXPECT_EQ(rows.Number(3), 0.5);
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      rows.Number(3), Error, HasSubstr("rows.csv:3: column 'weight_kg': nothing where a number"));
  EXPECT_THROWS_MESSAGE(rows.Required(2), Error, HasSubstr("no note given"));
  WriteFileAtomically(folder_ / "rows.csv", "size_m,name,note,note\n");
  EXPECT_THROWS_MESSAGE(CsvRows(folder_ / "rows.csv", kColumns, kOptional),
                        Error,
                        HasSubstr("column 'note' appears twice"));
}

}  // namespace
}  // namespace handcraft::datasets
