// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/set_fingerprint.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

TEST(FileDigest, IsTheHashOfTheBytes) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "a", "abc");
  // FIPS 180-2, appendix B.1
  EXPECT_EQ(FileDigest(folder / "a"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_THROWS_MESSAGE(FileDigest(folder / "no"), Error, HasSubstr("no: cannot open"));
}

TEST(FingerprintLine, PutsAZeroByteBeforeEachPart) {
  EXPECT_EQ(FingerprintLine("./a//b.png", {"x", "", "y"}), std::string("a/b.png\0x\0\0y\n", 13));
  EXPECT_EQ(FingerprintLine("a", {}), "a\n");
}

TEST(FingerprintOf, IsTheHashOfTheSortedLines) {
  Sha256 hash;
  hash.Update("B\na\nb\n");
  EXPECT_EQ(FingerprintOf({"b\n", "a\n", "B\n"}), hash.HexDigest());
  // printf '' | sha256sum
  EXPECT_EQ(FingerprintOf({}), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

}  // namespace
}  // namespace handcraft::datasets
