// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/mesh_text.h"

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

TEST(MeshText, CutsLinesIntoWordsAndSkipsEmptyOnes) {
  MeshText lines("a.obj", "v 1 2\r\n\n \t\nf  3\t4 \\\n 5\nlast");
  ASSERT_TRUE(lines.Next());
  EXPECT_EQ(lines.line(), 1U);
  EXPECT_EQ(lines.words(), (std::vector<std::string_view>{"v", "1", "2"}));
  ASSERT_TRUE(lines.Next());
  EXPECT_EQ(lines.line(), 4U);
  EXPECT_EQ(lines.words(), (std::vector<std::string_view>{"f", "3", "4", "5"}));
  ASSERT_TRUE(lines.Next());
  EXPECT_EQ(lines.line(), 6U);
  EXPECT_EQ(lines.at(), 27U);
  EXPECT_FALSE(lines.Next());
  EXPECT_FALSE(MeshText("a.obj", "").Next());
}

TEST(MeshText, ReadsNumbers) {
  MeshText lines("a.obj", "x 1.5 -2e3 +4 1e-60 -7");
  ASSERT_TRUE(lines.Next());
  EXPECT_FLOAT_EQ(lines.Number(1), 1.5F);
  EXPECT_FLOAT_EQ(lines.Number(2), -2000.0F);
  EXPECT_FLOAT_EQ(lines.Number(3), 4.0F);
  EXPECT_EQ(lines.Number(4), 0.0F) << "too small for a float";
  EXPECT_EQ(lines.Whole(5, -10, 10), -7);
  EXPECT_EQ(lines.From(3), "+4 1e-60 -7");
}

TEST(MeshText, RefusesWhatIsNoNumberByLineAndWord) {
  MeshText lines("a.obj", "\n\nx nan 1e60 2,5 1e999 12 \x01zz");
  ASSERT_TRUE(lines.Next());
  EXPECT_THROWS_MESSAGE(
      (void)lines.Number(1), Error, HasSubstr("a.obj:3: \"nan\" is no finite number"));
  EXPECT_THROWS_MESSAGE((void)lines.Number(2), Error, HasSubstr("\"1e60\" is no finite number"));
  EXPECT_THROWS_MESSAGE((void)lines.Number(3), Error, HasSubstr("\"2,5\" is no finite number"));
  EXPECT_THROWS_MESSAGE((void)lines.Number(4), Error, HasSubstr("\"1e999\" is no finite number"));
  EXPECT_THROWS_MESSAGE((void)lines.Number(6), Error, HasSubstr("\"?zz\" is no finite number"));
  EXPECT_THROWS_MESSAGE(
      (void)lines.Number(7), Error, HasSubstr("ends after 7 words; a number is due"));
  EXPECT_THROWS_MESSAGE((void)lines.Whole(5, 0, 11),
                        Error,
                        HasSubstr("\"12\" is no whole number from 0 to 11; one is due"));
  EXPECT_THROWS_MESSAGE((void)lines.Whole(9, 0, 1), Error, HasSubstr("ends after 9 words"));
}

}  // namespace
}  // namespace handcraft::datasets
