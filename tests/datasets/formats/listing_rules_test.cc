// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/listing_rules.h"

#include <array>
#include <optional>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr std::array<std::string_view, 1> kColumns = {"image"};

class ListingRules : public ::testing::Test {
 protected:
  // Rows to name the lines of.
  [[nodiscard]] CsvRows Rows() const {
    WriteFileAtomically(folder_ / "list.csv", "image\na\nb\nc\n");
    return CsvRows(folder_ / "list.csv", kColumns);
  }

  TemporaryDirectory folder_;
};

TEST_F(ListingRules, KeepPathsInTheFolder) {
  CsvRows rows = Rows();
  ASSERT_TRUE(rows.Next());
  for (const char* good : {"", "a.png", "x/y/a.png", "a..png", "./a.png"}) {
    EXPECT_NO_THROW(CheckLiesInFolder(rows.records(), "cloud", good)) << good;
  }
  for (const std::string& bad :
       {std::string("/a.png"), std::string("../a.png"), std::string("x/../../a.png")}) {
    EXPECT_THROWS_MESSAGE(
        CheckLiesInFolder(rows.records(), "cloud", bad),
        Error,
        AllOf(HasSubstr("list.csv:2: the cloud '"), HasSubstr("lies outside the folder")));
  }
  EXPECT_THROWS_MESSAGE(CheckLiesInFolder(rows.records(), "cloud", std::string_view("a\0.png", 6)),
                        Error,
                        HasSubstr("list.csv:2: the cloud 'a"));
}

TEST_F(ListingRules, ReadAnglesThatMayBeUnknown) {
  WriteFileAtomically(folder_ / "list.csv", "image,note\n0.10,\n,\n-7,\nleft,\n");
  CsvRows rows(folder_ / "list.csv", kColumns);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(ReadAngle(rows, 0), 0.1);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(ReadAngle(rows, 0), std::nullopt);
  ASSERT_TRUE(rows.Next());
  EXPECT_EQ(ReadAngle(rows, 0), -7.0);
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      ReadAngle(rows, 0), Error, HasSubstr("list.csv:5: column 'image': 'left' where a number"));
  EXPECT_EQ(AngleText(0.1), "0.1");
  EXPECT_EQ(AngleText(std::nullopt), "");
}

TEST_F(ListingRules, LetAnImageComeOnce) {
  CsvRows rows = Rows();
  SeenBefore seen;
  ASSERT_TRUE(rows.Next());
  seen.Check(rows.records(), "x/a.png", "mug", "train");
  ASSERT_TRUE(rows.Next());
  EXPECT_NO_THROW(seen.Check(rows.records(), "x/b.png", "mug", "train"));
  EXPECT_THROWS_MESSAGE(seen.Check(rows.records(), "x/./a.png", "mug", "train"),
                        Error,
                        HasSubstr("list.csv:3: the image 'x/./a.png' stands on line 2 already"));
}

TEST_F(ListingRules, KeepAnInstanceInOneSplit) {
  CsvRows rows = Rows();
  SeenBefore seen;
  ASSERT_TRUE(rows.Next());
  seen.Check(rows.records(), "a.png", "mug", "train");
  ASSERT_TRUE(rows.Next());
  seen.Check(rows.records(), "b.png", "cup", "test");
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      seen.Check(rows.records(), "c.png", "mug", "test"),
      Error,
      HasSubstr("list.csv:4: instance 'mug' is in split 'test' here and in 'train' on line 2"));
}

}  // namespace
}  // namespace handcraft::datasets
