// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/header_cursor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::runtime {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t kOffset = 8;

HeaderCursor CursorOver(std::string_view text) {
  return {{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, kOffset};
}

void ExpectError(const HeaderCursor& cursor, std::uint64_t offset, const std::string& part) {
  ASSERT_TRUE(cursor.Failed());
  EXPECT_EQ(cursor.error().status, HC_ERROR_FORMAT);
  EXPECT_EQ(cursor.error().byte_offset, offset);
  EXPECT_THAT(cursor.error().message, HasSubstr(part));
}

TEST(HeaderCursor, WalksOverAHeader) {
  HeaderCursor cursor = CursorOver(R"({"k":[12,0]}  )");
  std::string key;
  std::uint64_t number = 0;
  EXPECT_TRUE(cursor.Expect("{"));
  EXPECT_TRUE(cursor.ReadString(1, key));
  EXPECT_EQ(key, "k");
  EXPECT_TRUE(cursor.Expect(":["));
  EXPECT_TRUE(cursor.ReadInteger(number));
  EXPECT_EQ(number, 12U);
  EXPECT_TRUE(cursor.TakeIf(','));
  EXPECT_FALSE(cursor.TakeIf(','));
  EXPECT_TRUE(cursor.ReadInteger(number));
  EXPECT_EQ(number, 0U);
  EXPECT_TRUE(cursor.Expect("]}"));
  EXPECT_TRUE(cursor.ExpectPaddingToEnd());
  EXPECT_FALSE(cursor.Failed());
}

TEST(HeaderCursor, NamesWhatItFoundAndWhatItExpected) {
  HeaderCursor cursor = CursorOver("{]");
  EXPECT_FALSE(cursor.Expect("{}"));
  ExpectError(cursor, kOffset + 1, "holds ']' (0x5d) where } was expected");
}

TEST(HeaderCursor, SaysWhenTheHeaderEnds) {
  HeaderCursor cursor = CursorOver("{");
  EXPECT_FALSE(cursor.Expect("{\"a"));
  ExpectError(cursor, kOffset + 1, "the header ends where \"a was expected");
}

TEST(HeaderCursor, KeepsTheFirstErrorAndFailsFromThenOn) {
  HeaderCursor cursor = CursorOver("12");
  std::string text;
  std::uint64_t number = 0;
  EXPECT_FALSE(cursor.ReadString(10, text));
  EXPECT_FALSE(cursor.ReadInteger(number));
  EXPECT_FALSE(cursor.TakeIf('1'));
  EXPECT_FALSE(cursor.Expect("1"));
  EXPECT_FALSE(cursor.ExpectPaddingToEnd());
  ExpectError(cursor, kOffset, "where a string was expected");
}

TEST(HeaderCursor, ResolvesTheFourEscapes) {
  HeaderCursor cursor = CursorOver(R"("\"\\\n\t/é")");
  std::string text;
  EXPECT_TRUE(cursor.ReadString(100, text));
  EXPECT_EQ(text, "\"\\\n\t/é");
}

TEST(HeaderCursor, RefusesOtherStrings) {
  const struct {
    std::string_view json;
    std::uint64_t offset;
    std::string message;
  } cases[] = {
      {R"("\u0041")", kOffset + 2, "one of the escapes"},
      {R"("\/")", kOffset + 2, "one of the escapes"},
      {R"("\)", kOffset + 2, "the header ends where one of the escapes"},
      {R"("abc)", kOffset + 4, "the header ends where the end of a string"},
      {"\"a\nb\"", kOffset + 2, "where a printable character"},
      {std::string_view("\"a\0b\"", 5), kOffset + 2, "where a printable character"},
      {"\"\xFF\"", kOffset, "not UTF-8"},
      {R"("12345678901")", kOffset, "more than 10 bytes"},
  };
  for (const auto& c : cases) {
    HeaderCursor cursor = CursorOver(c.json);
    std::string text;
    EXPECT_FALSE(cursor.ReadString(10, text)) << c.json;
    ExpectError(cursor, c.offset, c.message);
  }
}

TEST(HeaderCursor, RefusesNumbersThatAreNotSizes) {
  const struct {
    std::string_view json;
    std::string message;
  } cases[] = {
      {"-1", "holds '-' (0x2d) where a whole number"},
      {"+1", "where a whole number"},
      {".5", "where a whole number"},
      {"\"1\"", "where a whole number"},
      {"", "the header ends where a whole number"},
      {"01", "leading zero"},
      {"00", "leading zero"},
      {"9007199254740993", "above 2^53"},
      {"99999999999999999999999999", "above 2^53"},
  };
  for (const auto& c : cases) {
    HeaderCursor cursor = CursorOver(c.json);
    std::uint64_t number = 0;
    EXPECT_FALSE(cursor.ReadInteger(number)) << c.json;
    ExpectError(cursor, kOffset, c.message);
  }
}

TEST(HeaderCursor, LeavesFractionsAndExponentsToFailNext) {
  for (const std::string_view json : {"1.0]", "1e3]"}) {
    HeaderCursor cursor = CursorOver(json);
    std::uint64_t number = 0;
    EXPECT_TRUE(cursor.ReadInteger(number));
    EXPECT_FALSE(cursor.Expect("]"));
    ExpectError(cursor, kOffset + 1, "where ] was expected");
  }
}

TEST(HeaderCursor, ReadsTheLargestNumber) {
  HeaderCursor cursor = CursorOver("9007199254740992");
  std::uint64_t number = 0;
  EXPECT_TRUE(cursor.ReadInteger(number));
  EXPECT_EQ(number, std::uint64_t{1} << 53);
}

TEST(HeaderCursor, AllowsOnlySpacesAsPadding) {
  for (const std::string_view padding :
       std::initializer_list<std::string_view>{"\t", " \n", "  x", {" \0", 2}}) {
    HeaderCursor cursor = CursorOver(padding);
    EXPECT_FALSE(cursor.ExpectPaddingToEnd());
    ExpectError(cursor, kOffset + padding.size() - 1, "where nothing but spaces was expected");
  }
}

TEST(HeaderCursor, AllowsNoMorePaddingThanAlignmentTakes) {
  const std::string spaces(64, ' ');
  HeaderCursor fits = CursorOver(std::string_view(spaces).substr(1));
  EXPECT_TRUE(fits.ExpectPaddingToEnd());
  HeaderCursor cursor = CursorOver(spaces);
  EXPECT_FALSE(cursor.ExpectPaddingToEnd());
  ExpectError(cursor, kOffset, "ends in 64 spaces where fewer than 64 were expected");
}

}  // namespace
}  // namespace handcraft::runtime
