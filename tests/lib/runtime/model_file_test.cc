// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_file.h"

#include <sys/stat.h>

#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::runtime {
namespace {

using ::testing::HasSubstr;

TEST(ReadModelFile, ReadsAllBytes) {
  const testing::TemporaryDirectory folder;
  for (const std::size_t size : {0U, 1U, 4096U, 100001U}) {
    const std::vector<std::uint8_t> bytes(size, 7);
    WriteFileAtomically(folder / "m", bytes);
    const auto read = ReadModelFile((folder / "m").c_str(), 1000000);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes);
  }
}

TEST(ReadModelFile, SaysWhyItCannot) {
  const testing::TemporaryDirectory folder;
  const auto missing = ReadModelFile("no/such.safetensors", 10);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().status, HC_ERROR_FILE);
  EXPECT_STREQ(missing.error().message,
               "cannot open: No such file or directory: no/such.safetensors");
  const auto is_folder = ReadModelFile(folder.path().c_str(), 10);
  ASSERT_FALSE(is_folder);
  EXPECT_EQ(is_folder.error().status, HC_ERROR_FILE);
  EXPECT_THAT(is_folder.error().message, HasSubstr("cannot read: Is a directory: /"));
}

TEST(ReadModelFile, RefusesMoreThanAllowed) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "m", "12345");
  EXPECT_TRUE(ReadModelFile((folder / "m").c_str(), 5));
  const auto larger = ReadModelFile((folder / "m").c_str(), 4);
  ASSERT_FALSE(larger);
  EXPECT_EQ(larger.error().status, HC_ERROR_FORMAT);
  EXPECT_THAT(larger.error().message, HasSubstr("larger than the 4 bytes"));
}

// A device tells no size and never ends.
TEST(ReadModelFile, StopsReadingAnEndlessDevice) {
  const auto endless = ReadModelFile("/dev/zero", 100000);
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().status, HC_ERROR_FORMAT);
}

TEST(ReadModelFile, ReadsAPipeToItsEnd) {
  const testing::TemporaryDirectory folder;
  const std::string path = folder / "pipe";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const std::string text(200000, 'x');
  std::thread writer([&] {
    std::FILE* pipe = std::fopen(path.c_str(), "w");
    std::fwrite(text.data(), 1, text.size(), pipe);
    std::fclose(pipe);
  });
  const auto read = ReadModelFile(path.c_str(), 1000000);
  writer.join();
  ASSERT_TRUE(read);
  EXPECT_EQ(std::string(read->begin(), read->end()), text);
}

}  // namespace
}  // namespace handcraft::runtime
