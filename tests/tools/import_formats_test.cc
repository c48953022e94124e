// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/import_formats.h"

#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "datasets/formats/labelled_image_set.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using testing::RunLine;
using ::testing::StartsWith;

TEST(ImportFormats, HaveNamesOfTheirOwnAndAnExample) {
  std::set<std::string> names;
  for (const ImportFormat& format : ImportFormats()) {
    EXPECT_TRUE(names.insert(format.name).second) << format.name;
    EXPECT_THAT(format.example, StartsWith(format.name + std::string(" ")));
    EXPECT_THAT(RunLine("data import --help").out,
                HasSubstr(std::string("\n  ") + format.name + " "));
    const std::string help = RunLine("data import " + std::string(format.name) + " --help").out;
    EXPECT_THAT(help, HasSubstr("--instance-pattern REGEX")) << format.name;
  }
}

TEST(ImportFormats, TakeTheOptionsOfFolders) {
  const TemporaryDirectory folder;
  const std::string line = "data import folders " HANDCRAFT_SOURCE_DIR
                           "/datasets/samples/cornell_mini --image-suffix r --out " +
                           folder.path().string();
  // Without values, don't care is nonzero and so good.
  ASSERT_EQ(RunLine(line + "/a").code, 0);
  ASSERT_EQ(RunLine(line + "/b --good 255 --dont-care 128 --dont-care 7").code, 0);
  const auto good = [&](const char* name) {
    const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(folder / name);
    const Image mask = datasets::ReadMask(set, 0);
    return std::count(mask.values().begin(), mask.values().end(), datasets::kMaskGood);
  };
  EXPECT_GT(good("a"), good("b"));
  EXPECT_EQ(RunLine(line + "/c --good 256").code, 2);
  EXPECT_THAT(RunLine(line + "/c --good 256").err,
              HasSubstr("--good: 256 given; it must be from 0 to 255"));
  EXPECT_EQ(RunLine(line + "/c --mask-suffix x").code, 3);
  EXPECT_EQ(RunLine(line + "/c --instance-pattern (").code, 2);
}

}  // namespace
}  // namespace handcraft::tools
