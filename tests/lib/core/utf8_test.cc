// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/utf8.h"

#include <string>

#include <gtest/gtest.h>

namespace handcraft {
namespace {

// Examples of RFC 3629 and of "UTF-8 decoder capability and stress test" (M. Kuhn).
TEST(IsUtf8, TellsGoodFromBad) {
  for (const std::string_view good : {"",
                                      "a",
                                      "\xC2\x80",
                                      "\xE0\xA0\x80",
                                      "\xED\x9F\xBF",
                                      "\xEF\xBF\xBF",
                                      "\xF0\x90\x80\x80",
                                      "\xF4\x8F\xBF\xBF"}) {
    EXPECT_TRUE(IsUtf8(good));
  }
  for (const std::string_view bad : {"\x80",
                                     "\xC0\x80",
                                     "\xC1\xBF",
                                     "\xC2",
                                     "\xC2g",
                                     "\xE0\x9F\xBF",
                                     "\xED\xA0\x80",
                                     "\xE2\x82",
                                     "\xF0\x8F\xBF\xBF",
                                     "\xF4\x90\x80\x80",
                                     "\xF5\x80\x80\x80",
                                     "\xFF",
                                     "\xF0\x90\x80g"}) {
    EXPECT_FALSE(IsUtf8(bad));
  }
}

TEST(Utf8PrefixLength, EndsWhereTheFaultBegins) {
  EXPECT_EQ(Utf8PrefixLength(""), 0U);
  EXPECT_EQ(Utf8PrefixLength("größe"), std::string_view("größe").size());
  EXPECT_EQ(Utf8PrefixLength("gr\xF6\xDF"), 2U);
  EXPECT_EQ(Utf8PrefixLength("ab\xC3"), 2U);
}

TEST(OnOneLine, WritesControlCharactersAsText) {
  EXPECT_EQ(OnOneLine("größe 1"), "größe 1");
  EXPECT_EQ(OnOneLine("a\nb\tc\rd\x1B\x7F"), "a\\nb\\tc\\rd\\x1B\\x7F");
  EXPECT_EQ(OnOneLine(std::string_view("\0", 1)), "\\x00");
}

}  // namespace
}  // namespace handcraft
