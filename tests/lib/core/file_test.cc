// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iterator>
#include <thread>
#include <vector>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

using ::testing::HasSubstr;

std::size_t NumEntries(const std::filesystem::path& folder) {
  using Iterator = std::filesystem::directory_iterator;
  return static_cast<std::size_t>(std::distance(Iterator(folder), Iterator()));
}

TEST(ReadFile, ReturnsWhatWasWritten) {
  const testing::TemporaryDirectory folder;
  for (const std::size_t size : {0U, 1U, 4095U, 4096U, 4097U, 1000000U}) {
    std::vector<std::uint8_t> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * 31);
    WriteFileAtomically(folder / "f", bytes);
    EXPECT_EQ(ReadFile(folder / "f"), bytes);
  }
}

TEST(ReadFile, NamesAMissingFile) {
  EXPECT_THROWS_MESSAGE(
      ReadFile("no/such"), Error, HasSubstr("no/such: cannot open: No such file"));
}

TEST(ReadFile, RefusesAFolder) {
  const testing::TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(ReadFile(folder.path()), Error, HasSubstr("Is a directory"));
}

TEST(ReadFile, RefusesWhatNeverEnds) {
  const testing::TemporaryDirectory folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROWS_MESSAGE(
      ReadFile(folder / "pipe"), Error, HasSubstr("pipe: is a pipe or a device; a file is due"));
  EXPECT_THROWS_MESSAGE(
      ReadFile("/dev/zero"), Error, HasSubstr("/dev/zero: is a pipe or a device"));
}

TEST(ReadFile, RefusesMoreThanAllowed) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "f", "12345");
  EXPECT_EQ(ReadFile(folder / "f", 5).size(), 5U);
  EXPECT_THROWS_MESSAGE(ReadFile(folder / "f", 4), Error, HasSubstr("larger than the 4 bytes"));
}

TEST(WriteFileAtomically, ReplacesAFileAndLeavesNothingElse) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "f", "old");
  WriteFileAtomically(folder / "f", "new");
  EXPECT_EQ(ReadTextFile(folder / "f"), "new");
  EXPECT_EQ(NumEntries(folder.path()), 1U);
}

// umask is the process's: to read it is to set it, for other threads that create files too.
TEST(WriteFileAtomically, GivesPermissionsByUmaskWhateverOtherThreadsDo) {
  const testing::TemporaryDirectory folder;
  const mode_t before = ::umask(027);
  std::vector<std::thread> threads;
  threads.reserve(8);
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&folder, t] {
      for (int i = 0; i < 10; ++i) {
        WriteFileAtomically(folder / (std::to_string(t) + "_" + std::to_string(i)), "text");
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(::umask(before), 027U);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_EQ(static_cast<unsigned>(entry.status().permissions()), 0640U) << entry.path();
  }
}

TEST(WriteFileAtomically, ReplacesTheTargetOfALink) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "target", "old");
  std::filesystem::create_symlink("target", folder / "link");
  WriteFileAtomically(folder / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(ReadTextFile(folder / "target"), "new");
  EXPECT_EQ(NumEntries(folder.path()), 2U);
}

TEST(WriteFileAtomically, WritesIntoAPipeAndLeavesItAPipe) {
  const testing::TemporaryDirectory folder;
  const std::filesystem::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  WriteFileAtomically(pipe, "text");
  char buffer[16] = {};
  EXPECT_EQ(::read(reader, buffer, sizeof buffer), 4);
  EXPECT_STREQ(buffer, "text");
  ::close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(WriteFileAtomically, SaysThatADeviceIsFull) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_THROWS_MESSAGE(WriteFileAtomically("/dev/full", "x"),
                        Error,
                        HasSubstr("cannot write: No space left on device (free some space"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(WriteFileAtomically, NeedsTheFolder) {
  const testing::TemporaryDirectory folder;
  EXPECT_THROWS_MESSAGE(
      WriteFileAtomically(folder / "no/f", "x"), Error, HasSubstr("cannot create the file"));
}

TEST(WriteFileAtomically, KeepsTheOldFileWhenTheDiskIsFull) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "f", "old");
  {
    const testing::FullDisk full_disk;
    EXPECT_THROWS_MESSAGE(WriteFileAtomically(folder / "f", std::string(5000, 'x')),
                          Error,
                          HasSubstr("cannot write: File too large"));
  }
  EXPECT_EQ(ReadTextFile(folder / "f"), "old");
  EXPECT_EQ(NumEntries(folder.path()), 1U);
}

TEST(WriteFileAtomically, ReportsADeviceWithoutSpace) {
  EXPECT_THROWS_MESSAGE(
      WriteFileAtomically("/dev/null/f", "x"), Error, HasSubstr("Not a directory"));
}

}  // namespace
}  // namespace handcraft
