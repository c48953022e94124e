// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/structured_text/toml_file.h"

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

TEST(ReadTomlFile, ReadsATable) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "a.toml", "[camera]\nwidth_px = 640\n");
  const toml::table table = ReadTomlFile(folder / "a.toml");
  EXPECT_EQ(table["camera"]["width_px"].value<int>(), 640);
  WriteFileAtomically(folder / "empty.toml", "");
  EXPECT_TRUE(ReadTomlFile(folder / "empty.toml").empty());
}

TEST(ReadTomlFile, NamesTheLineThatIsNoToml) {
  const TemporaryDirectory folder;
  for (const char* text :
       {"a = 1\nb = [\n", "a = 1\nx\n", "a = 1\na = 2\n", "a = 1\nb = \"\xff\"\n"}) {
    WriteFileAtomically(folder / "bad.toml", text);
    EXPECT_THROWS_MESSAGE(ReadTomlFile(folder / "bad.toml"), Error, HasSubstr("not TOML: "));
  }
  WriteFileAtomically(folder / "bad.toml", "a = 1\nx\n");
  EXPECT_THROWS_MESSAGE(
      ReadTomlFile(folder / "bad.toml"), Error, HasSubstr("bad.toml:2: not TOML"));
  EXPECT_THROWS_MESSAGE(ReadTomlFile(folder / "no.toml"), Error, HasSubstr("No such file"));
}

TEST(ParseToml, NamesTheLineOfTheFault) {
  EXPECT_THROWS_MESSAGE(ParseToml("a = 1\nb = = 2\n", "g.toml"), Error, HasSubstr("g.toml:2"));
  EXPECT_THROWS_MESSAGE(ParseToml("a = 1\na = 2\n", "g.toml"), Error, HasSubstr("g.toml"));
}

}  // namespace
}  // namespace handcraft
