// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/import_formats.h"

#include <algorithm>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/view_set.h"
#include "datasets/view_set_faults.h"
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

TEST(ImportFormats, TakeTheOptionsOfLabelledParts) {
  const TemporaryDirectory folder;
  const std::string line =
      "data import umd " HANDCRAFT_SOURCE_DIR "/tests/data/umd --out " + folder.path().string();
  EXPECT_THAT(RunLine("data import umd --help").out, HasSubstr("without it 'grasp', 'wrap-grasp'"));
  EXPECT_THAT(RunLine("data import coco --help").out, HasSubstr("without it 'good'"));
  ASSERT_EQ(RunLine(line + "/both").code, 0);
  ASSERT_EQ(RunLine(line + "/handle --good grasp").code, 0);
  const auto good = [&](const char* name) {
    const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(folder / name);
    EXPECT_EQ(set.items.at(0).object_class, "mug");
    const Image mask = datasets::ReadMask(set, 0);
    return std::count(mask.values().begin(), mask.values().end(), datasets::kMaskGood);
  };
  EXPECT_EQ(good("both"), 60 * 12 + 30 * 6);
  EXPECT_EQ(good("handle"), 30 * 6);
}

TEST(ImportFormats, PairLabelsBesidePictures) {
  const TemporaryDirectory folder;
  const std::string line = "data import saxena " HANDCRAFT_SOURCE_DIR "/tests/data/saxena --out " +
                           folder.path().string();
  ASSERT_EQ(RunLine(line + "/set").code, 0);
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(folder / "set");
  ASSERT_EQ(set.items.size(), 1U);
  EXPECT_EQ(set.items[0].object_class, "mug");
  const Image mask = datasets::ReadMask(set, 0);
  EXPECT_EQ(mask.At(19, 10), datasets::kMaskGood) << "handle";
  EXPECT_EQ(mask.At(10, 10), datasets::kMaskBad) << "wall";
  EXPECT_THAT(RunLine(line + "/no --label-suffix _grasp").err,
              HasSubstr("left out, the first of 2: no mask: expected "));
}

TEST(ImportFormats, MakeViewsOfTurntables) {
  const TemporaryDirectory folder;
  const auto import = [&](const std::string& format, const std::string& options = "") {
    const std::string out = (folder / std::to_string(options.size())).string();
    const testing::Outcome outcome =
        RunLine("data import " + format + " " HANDCRAFT_SOURCE_DIR "/tests/data/views/" + format +
                " --out " + out + format + " --test-share 0 " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return datasets::ReadViewSet(out + format);
  };
  EXPECT_EQ(import("eth80").items.size(), 4U);
  EXPECT_EQ(import("coil").items.at(1).angle_deg, 5.0);
  const datasets::ViewSet washington = import("washington");
  EXPECT_EQ(washington.items.at(1).angle_deg, 7.5);
  EXPECT_FALSE(washington.items.at(1).cloud.empty());
  const datasets::ViewSet bop = import("bop");
  EXPECT_EQ(bop.items.at(0).angle_deg, 0.0);
  EXPECT_TRUE(datasets::FindFaults(bop).empty());
  EXPECT_GT(datasets::ReadObjectMask(import("bop", "--margin 2"), 0).width(), 0);
  const std::string source = HANDCRAFT_SOURCE_DIR "/tests/data/views/";
  const std::string out = " --out " + (folder / "no").string();
  EXPECT_THAT(RunLine("data import eth80 " + source + "eth80 --polar 45" + out).err,
              HasSubstr("angles PPP found: 90"));
  EXPECT_EQ(RunLine("data import coil " + source + "coil --threshold 256" + out).code, 2);
  EXPECT_THAT(RunLine("data import coil " + source + "coil --json" + out).out,
              HasSubstr("\"num_views\": 4"));
}

}  // namespace
}  // namespace handcraft::tools
