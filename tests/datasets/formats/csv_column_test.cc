// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/csv_column.h"

#include <string>
#include <vector>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

// The file after its column "b" has been rewritten.
std::string Rewritten(const std::string& text, const std::vector<std::string>& values) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "list.csv", text);
  RewriteCsvColumn(folder / "list.csv", "b", values);
  return ReadTextFile(folder / "list.csv");
}

TEST(RewriteCsvColumn, LeavesEveryOtherFieldAlone) {
  EXPECT_EQ(Rewritten("a,b,c\n1,2,3\n4,5,6\n", {"x", ""}), "a,b,c\n1,x,3\n4,,6\n");
  EXPECT_EQ(Rewritten("\xEF\xBB\xBF"
                      "b\r\nold\r\n\r\n",
                      {"x,y"}),
            "b\n\"x,y\"\n");
  EXPECT_EQ(Rewritten("a,b\n\"1, \"\"q\"\"\",2\n", {"2"}), "a,b\n\"1, \"\"q\"\"\",2\n");
  EXPECT_EQ(Rewritten("a,b\nM\xE4use,2\n", {"3"}), "a,b\nM\xE4use,3\n") << "any bytes";
}

TEST(RewriteCsvColumn, RefusesAFileThatDoesNotFit) {
  const auto expect = [](const std::string& text, const std::string& message) {
    EXPECT_THROWS_MESSAGE(Rewritten(text, {"x", "y"}), Error, HasSubstr("list.csv" + message));
  };
  expect("", ": the file is empty");
  expect("a,c\n1,2\n3,4\n", ":1: no column 'b'");
  expect("a,b\n1,2\n3\n", ":3: the row ends before column 'b'");
  expect("a,b\n1,2\n", ": 1 rows; 2 are due");
  expect("a,b\n1,2\n3,4\n5,6\n", ": 3 rows; 2 are due");
  EXPECT_THROWS_MESSAGE(RewriteCsvColumn("no/such.csv", "b", {}), Error, HasSubstr("cannot open"));
}

TEST(RewriteCsvColumn, WritesNothingWhenItRefuses) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "list.csv", "b\n1\n");
  EXPECT_THROW(RewriteCsvColumn(folder / "list.csv", "b", {}), Error);
  EXPECT_EQ(ReadTextFile(folder / "list.csv"), "b\n1\n");
}

}  // namespace
}  // namespace handcraft::datasets
