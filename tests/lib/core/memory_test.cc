// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/memory.h"

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

using ::testing::StrEq;

TEST(AvailableMemory, IsWhatLinuxTells) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "meminfo",
                      "MemTotal:       16384000 kB\n"
                      "MemFree:          123456 kB\n"
                      "MemAvailable:    2000000 kB\n");
  EXPECT_EQ(AvailableMemory(folder / "meminfo"), 2000000ULL * 1024);
}

TEST(AvailableMemory, IsUnknownElsewhere) {
  const testing::TemporaryDirectory folder;
  EXPECT_EQ(AvailableMemory(folder / "missing"), std::nullopt);
  WriteFileAtomically(folder / "meminfo", "MemTotal: many\n");
  EXPECT_EQ(AvailableMemory(folder / "meminfo"), std::nullopt);
}

TEST(RequireMemory, SaysHowMuchIsNeededAndThere) {
  EXPECT_THROWS_MESSAGE(
      RequireMemory(14'745'600'001, 3'210'999'999, "the table", "use less"),
      Error,
      StrEq("the table needs 14746 MB of memory, of which 3210 MB are available (use less)"));
}

TEST(RequireMemory, LetsPassWhatFitsOrIsNotKnown) {
  RequireMemory(7, 7, "the table", "use less");
  RequireMemory(~std::uint64_t{0}, std::nullopt, "the table", "use less");
}

}  // namespace
}  // namespace handcraft
