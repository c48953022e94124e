// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/listing_rules.h"

#include <array>

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
    EXPECT_NO_THROW(CheckLiesInFolder(rows, "cloud", good)) << good;
  }
  for (const std::string& bad :
       {std::string("/a.png"), std::string("../a.png"), std::string("x/../../a.png")}) {
    EXPECT_THROWS_MESSAGE(
        CheckLiesInFolder(rows, "cloud", bad),
        Error,
        AllOf(HasSubstr("list.csv:2: the cloud '"), HasSubstr("lies outside the folder")));
  }
  EXPECT_THROWS_MESSAGE(CheckLiesInFolder(rows, "cloud", std::string_view("a\0.png", 6)),
                        Error,
                        HasSubstr("list.csv:2: the cloud 'a"));
}

TEST_F(ListingRules, LetAnImageComeOnce) {
  CsvRows rows = Rows();
  SeenBefore seen;
  ASSERT_TRUE(rows.Next());
  seen.Check(rows, "x/a.png", "mug", "train");
  ASSERT_TRUE(rows.Next());
  EXPECT_NO_THROW(seen.Check(rows, "x/b.png", "mug", "train"));
  EXPECT_THROWS_MESSAGE(seen.Check(rows, "x/./a.png", "mug", "train"),
                        Error,
                        HasSubstr("list.csv:3: the image 'x/./a.png' stands on line 2 already"));
}

TEST_F(ListingRules, KeepAnInstanceInOneSplit) {
  CsvRows rows = Rows();
  SeenBefore seen;
  ASSERT_TRUE(rows.Next());
  seen.Check(rows, "a.png", "mug", "train");
  ASSERT_TRUE(rows.Next());
  seen.Check(rows, "b.png", "cup", "test");
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      seen.Check(rows, "c.png", "mug", "test"),
      Error,
      HasSubstr("list.csv:4: instance 'mug' is in split 'test' here and in 'train' on line 2"));
}

}  // namespace
}  // namespace handcraft::datasets
