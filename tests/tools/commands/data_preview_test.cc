// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/hold_set.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_demonstration_set.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

const std::string kSample = HANDCRAFT_SOURCE_DIR "/datasets/samples/cornell_mini";

TEST(DataPreview, DrawsTheSample) {
  const TemporaryDirectory folder;
  const std::string out = (folder / "sheet.png").string();
  const Outcome outcome = RunLine("data preview " + kSample + " --out " + out +
                                  " --images-per-class 1 --tile-width 64 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  const Image sheet = perception::ReadImage(out);
  EXPECT_EQ(json["width_px"], 128);
  EXPECT_EQ(sheet.width(), 128);
  EXPECT_EQ(json["height_px"], sheet.height());
}

TEST(DataPreview, GoesNearToObjects) {
  const TemporaryDirectory folder;
  const std::string out = (folder / "sheet.png").string();
  const std::string line = "data preview " + kSample + " --out " + out + " --close-up";
  ASSERT_EQ(RunLine(line + " --images-per-class 1 --tile-width 64").code, 0);
  EXPECT_EQ(perception::ReadImage(out).width(), 3 * 64) << "whole, near, near with labels";
  ASSERT_EQ(RunLine(line + " --page 1 --columns 2 --rows 1 --tile-width 64").code, 0);
  EXPECT_EQ(perception::ReadImage(out).width(), 2 * (2 * 64 + 4)) << "whole, near with labels";
  const Outcome outcome = RunLine(line + " --poses");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--close-up"));
}

TEST(DataPreview, LeafsThroughASet) {
  const TemporaryDirectory folder;
  const std::string out = (folder / "page.png").string();
  const Outcome outcome = RunLine("data preview " + kSample + " --out " + out +
                                  " --split test --page 2 --columns 2 --rows 3 --tile-width 64");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("page 2 of 2"));
  const Image page = perception::ReadImage(out);
  EXPECT_EQ(page.width(), 2 * 68);
  EXPECT_EQ(page.height(), 68) << "8 test pictures: 6 and 2";
}

TEST(DataPreview, DrawsShownPoses) {
  const TemporaryDirectory folder;
  handcraft::testing::MakeDemonstrationSet(folder.path());
  const std::string root = folder.path().string();
  const std::string out = (folder / "sheet.png").string();
  const Outcome outcome = RunLine("data preview " + root + " --out " + out +
                                  " --poses --poses-per-view 5 --tile-width 64 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["num_images"], 3);
  EXPECT_EQ(perception::ReadImage(out).width(), 2 * 64) << "two views of the mug";
  EXPECT_EQ(RunLine("data preview " + root + " --out " + root + "/views.csv --poses").code, 2);
  EXPECT_EQ(RunLine("data preview " + root + " --out " + out + " --poses --page 1").code, 0);
  EXPECT_EQ(perception::ReadImage(out).width(), 3 * (240 + 4));
  EXPECT_EQ(RunLine("data preview " + kSample + " --out " + out + " --poses").code, 3);
}

TEST(DataPreview, DrawsBothHandsOfHolds) {
  const TemporaryDirectory folder;
  handcraft::testing::MakeDemonstrationSet(folder.path());
  const std::string root = folder.path().string();
  const std::string line = "data preview " + root + " --out " + (folder / "sheet.png").string();
  EXPECT_THAT(RunLine(line + " --holds").err, HasSubstr("holds.csv"));
  datasets::WriteHolds({.root = folder.path(), .items = {{"can", "can", "can_0.png", {}, {}}}});
  const Outcome outcome = RunLine(line + " --holds --poses-per-view 5 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["num_images"], 1);
  EXPECT_EQ(json["width_px"], 240);
  EXPECT_THAT(RunLine(line + " --holds --poses").err, HasSubstr("--poses excludes --holds"));
  EXPECT_THAT(RunLine(line + " --poses-per-view 5").err, HasSubstr("give --poses or --holds"));
}

TEST(DataPreview, DrawsViewsTheirDepthsAndTheirObjects) {
  const TemporaryDirectory folder;
  handcraft::testing::MakeDemonstrationSet(folder.path());
  const std::string root = folder.path().string();
  const std::string out = (folder / "sheet.png").string();
  const Outcome outcome =
      RunLine("data preview " + root + " --out " + out + " --class mug --tile-width 64");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(perception::ReadImage(out).width(), 2 * 3 * 64);
  EXPECT_EQ(RunLine("data preview " + root + " --out " + root + "/mug_0.pcd").code, 2);
}

TEST(DataPreview, ChoosesAClass) {
  const TemporaryDirectory folder;
  const std::string out = (folder / "sheet.png").string();
  const Outcome outcome =
      RunLine("data preview " + kSample + " --out " + out + " --class no_such_class");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no class 'no_such_class'; there are: "));
}

TEST(DataPreview, RefusesToOverwriteItsInput) {
  const std::string manifest = kSample + "/manifest.csv";
  const std::string before = ReadTextFile(manifest);
  EXPECT_EQ(RunLine("data preview " + kSample + " --out " + manifest).code, 2);
  EXPECT_EQ(ReadTextFile(manifest), before);
}

TEST(DataPreview, NamesWhatIsWrong) {
  const Outcome other_kind = RunLine("data preview " + kSample + " --out x.jpg");
  EXPECT_EQ(other_kind.code, 2);
  EXPECT_THAT(other_kind.err, HasSubstr("x.jpg: --out: the sheet is written as PNG"));
  EXPECT_THAT(RunLine("data preview " + kSample + " --out x.png --page 1 --images-per-class 3").err,
              HasSubstr("--images-per-class excludes --page"));
  EXPECT_THAT(RunLine("data preview no/such --out sheet.png").err, HasSubstr("no/such"));
  EXPECT_EQ(RunLine("data preview " + kSample + " --out no/folder/sheet.png").code, 3);
  EXPECT_THAT(RunLine("data preview " + kSample + " --out x.png --page 9").err,
              HasSubstr("no page 9; the last is page 1 (24 pictures, 48 a page)"));
  EXPECT_THAT(RunLine("data preview " + kSample + " --out x.png --rows 3").err,
              HasSubstr("--rows requires --page"));
  EXPECT_THAT(RunLine("data preview " + kSample + " --out x.png --tile-width 3").err,
              HasSubstr("--tile-width: 3 given; it must be from 16 to 640"));
}

}  // namespace
}  // namespace handcraft::tools
