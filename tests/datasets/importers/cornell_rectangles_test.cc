// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cornell_rectangles.h"

#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<GraspRectangle> ReadText(std::string_view text) {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder / "pcd0100cpos.txt", std::ios::binary) << text;
  return ReadCornellRectangles(folder / "pcd0100cpos.txt");
}

TEST(ReadCornellRectangles, ReadsAFileAsItIsDistributed) {
  const auto rectangles =
      ReadText("253 319.7 \r\n309 324 \r\n307 350 \r\n251 346 \r\n1e1\t0\n20 0\n20 5\n10 5\n\n");
  ASSERT_THAT(rectangles, SizeIs(2));
  EXPECT_EQ(rectangles[0][0], (std::array{253.0, 319.7}));
  EXPECT_EQ(rectangles[0][3], (std::array{251.0, 346.0}));
  EXPECT_EQ(rectangles[1][2], (std::array{20.0, 5.0}));
}

TEST(ReadCornellRectangles, LeavesOutWhatHasNoPlaceOrArea) {
  const std::string good = "0 0\n5 0\n5 5\n0 5\n";
  EXPECT_THAT(ReadText("NaN NaN\n1 2\n3 4\nnan 5\n" + good), SizeIs(1));
  EXPECT_THAT(ReadText("1 1\n2 2\n3 3\n4 4\n" + good), SizeIs(1));
  EXPECT_THAT(ReadText(""), IsEmpty());
}

TEST(ReadCornellRectangles, NamesTheLine) {
  EXPECT_THROWS_MESSAGE(
      ReadText("0 0\n5 0\nfive 5\n0 5\n"), Error, HasSubstr("cpos.txt:3: 'five 5' where a corner"));
  EXPECT_THROWS_MESSAGE(ReadText("0 0\n5\n"), Error, HasSubstr(":2: '5'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 0 0\n"), Error, HasSubstr(":1: '0 0 0'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 inf\n"), Error, HasSubstr(":1: '0 inf'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 1e9\n"), Error, HasSubstr(":1: '0 1e9'"));
  EXPECT_THROWS_MESSAGE(ReadText("0 0\n5 0\n5 5\n"), Error, HasSubstr(":3: 3 corners"));
}

}  // namespace
}  // namespace handcraft::datasets
