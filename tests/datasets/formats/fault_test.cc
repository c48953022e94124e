// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/fault.h"

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using testing::TemporaryDirectory;

TEST(FaultOf, KeepsPlaceReasonAndRemedy) {
  const Fault fault = FaultOf(
      Error({.path = "/sets/a/views.csv", .line = 7, .reason = "wrong", .remedy = "r"}), "/sets/a");
  EXPECT_EQ(fault.path, "views.csv");
  EXPECT_EQ(fault.line, 7U);
  EXPECT_EQ(fault.reason, "wrong");
  EXPECT_EQ(fault.remedy, "r");
  EXPECT_EQ(FaultOf(Error({.path = "/sets/a/b/c.png", .reason = "w"}), "/sets/a").path, "b/c.png");
  EXPECT_EQ(FaultOf(Error({.path = "/sets/a/c.png", .reason = "w"}), "/sets/a").line, std::nullopt);
}

TEST(CollectFaults, KeepsErrorsAndNothingElse) {
  std::vector<Fault> faults;
  CollectFaults("r", faults, [] {});
  EXPECT_THAT(faults, IsEmpty());
  CollectFaults("r", faults, [] { throw Error({.path = "r/a.png", .reason = "bad"}); });
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].path, "a.png");
  EXPECT_THROW(CollectFaults("r", faults, [] { throw std::logic_error("ours"); }),
               std::logic_error);
}

constexpr std::array<std::string_view, 2> kColumns = {"x", "name"};

// The faults of such rows, by line; a row is sound when x is a number.
std::vector<std::pair<std::size_t, std::string>> FaultsOf(const std::string& text,
                                                          std::size_t num_rows) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "list.csv", "x,name\n" + text);
  CsvRows rows(folder / "list.csv", kColumns);
  RowFindings findings;
  FindRowFaults(
      rows,
      folder.path(),
      [&] { return std::to_string(rows.Number(0)) + std::string(rows.Text(1)); },
      findings);
  EXPECT_EQ(findings.num_rows, num_rows);
  std::vector<std::pair<std::size_t, std::string>> faults;
  for (const Fault& fault : findings.faults) {
    EXPECT_EQ(fault.path, "list.csv");
    faults.emplace_back(fault.line.value_or(0), fault.reason);
  }
  return faults;
}

TEST(FindRowFaults, NamesEachLineAndGoesOn) {
  EXPECT_THAT(FaultsOf("1,a\n2,b\n1,b\n", 3), IsEmpty());
  EXPECT_THAT(FaultsOf("1,a\nleft,b\n1.0,a\n\nnan,c\n3,d\n", 5),
              ElementsAre(Pair(3, HasSubstr("'left' where a number is due")),
                          Pair(4, "the same row as on line 2"),
                          Pair(6, HasSubstr("is not a finite number"))));
}

TEST(FindRowFaults, EndsWhereTheTextIsNoCsv) {
  EXPECT_THAT(FaultsOf("no,a\n1,b,c\nno,d\n", 1),
              ElementsAre(Pair(2, HasSubstr("'no'")), Pair(3, HasSubstr("3 fields"))));
  EXPECT_THAT(FaultsOf("1,\"b\n", 0), ElementsAre(Pair(2, HasSubstr("never closed"))));
}

TEST(FindRowFaults, WantsARow) {
  EXPECT_THAT(FaultsOf("", 0), ElementsAre(Pair(1, "no row is listed")));
}

}  // namespace
}  // namespace handcraft::datasets
