// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdint>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;
using ::testing::StartsWith;

constexpr const char* kTree = HANDCRAFT_SOURCE_DIR "/tests/data/cornell";

class DataImport : public ::testing::Test {
 protected:
  [[nodiscard]] Outcome Import(const std::string& options = "") const {
    return RunLine("data import cornell " + std::string(kTree) + " --out " + out_.string() + " " +
                   options);
  }

  TemporaryDirectory folder_;
  std::filesystem::path out_ = folder_ / "set";
};

TEST_F(DataImport, MakesASetThatPassesTheCheck) {
  const Outcome outcome = Import("--split-gap 0");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("Wrote 6 images with masks to "));
  EXPECT_EQ(RunLine("data check " + out_.string()).code, 0);
}

TEST_F(DataImport, TakesItsOptions) {
  const auto json = nlohmann::json::parse(
      Import("--json --max-images 3 --test-share 0.34 --split-gap 0 --instance-span 1 --licence "
             "CC0-1.0")
          .out);
  EXPECT_EQ(json["num_images"], 3);
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(out_);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(set));
  EXPECT_EQ(set.items.front().licence, "CC0-1.0");
  EXPECT_EQ(set.Only("test").items.size(), 1U);
}

TEST_F(DataImport, ChangesTheMasksWithThePolicy) {
  ASSERT_EQ(Import("--split-gap 0").code, 0);
  const auto strict = ReadFile(out_ / datasets::ReadLabelledImageSet(out_).items[0].mask);
  std::filesystem::remove_all(out_);
  ASSERT_EQ(Import("--split-gap 0 --good-share 1 --dont-care-margin 0").code, 0);
  EXPECT_NE(ReadFile(out_ / datasets::ReadLabelledImageSet(out_).items[0].mask), strict);
  std::filesystem::remove_all(out_);
  ASSERT_EQ(Import("--split-gap 0 --no-negative-rectangles").code, 0);
}

TEST_F(DataImport, RefusesAFolderThatIsNotEmpty) {
  WriteFileAtomically(folder_ / "mine", "precious");
  const Outcome outcome =
      RunLine("data import cornell " + std::string(kTree) + " --out " + folder_.path().string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(ReadTextFile(folder_ / "mine"), "precious");
  EXPECT_EQ(NumEntries(folder_.path()), 1U);
}

TEST_F(DataImport, LeavesNothingOnFailure) {
  const Outcome outcome = RunLine("data import cornell no/such/tree --out " + out_.string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no/such/tree"));
  EXPECT_EQ(Import("--good-share 0").code, 2);
  EXPECT_EQ(NumEntries(folder_.path()), 0U);
}

TEST_F(DataImport, WarnsOfAPictureThatIsThereTwice) {
  testing::WriteImageSet(folder_ / "source");
  const std::string line = "data import folders " + (folder_ / "source").string() +
                           " --images . --masks . --mask-suffix _mask --out " + out_.string();
  EXPECT_EQ(RunLine(line).err, "");
  std::filesystem::remove_all(out_);
  for (const std::string ending : {".png", "_mask.png"}) {
    std::filesystem::copy_file(folder_ / "source" / ("p0" + ending),
                               folder_ / "source" / ("p9" + ending));
  }
  const Outcome outcome = RunLine(line);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("p9.png: is the same picture as "));
  EXPECT_EQ(RunLine("data check " + out_.string()).code, 3) << "which is what it warns of";
}

TEST_F(DataImport, TellsOfShapesThatCoverNothing) {
  testing::WriteImageSet(folder_ / "source");
  WriteFileAtomically(
      folder_ / "source" / "p0.json",
      R"({"shapes": [{"label": "good", "shape_type": "polygon", "points": [[1, 1], [2, 2], [3, 3]]}],)"
      R"( "imagePath": "p0.png", "imageData": null})");
  const std::string line =
      "data import labelme " + (folder_ / "source").string() + " --out " + out_.string();
  const Outcome outcome = RunLine(line);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("p0.json: at /shapes/0: the shape covers no pixel, nothing is drawn "
                              "of it (draw it larger, or remove it)"),
                    HasSubstr("masks/p0.png: no good pixel (255): training draws nothing")));
  std::filesystem::remove_all(out_);
  const auto json = nlohmann::json::parse(RunLine(line + " --json").out);
  ASSERT_EQ(json["notes"].size(), 3U);
  EXPECT_EQ(json["notes"][0]["reason"],
            "left out, the first of 11: no LabelMe file names this picture");
  EXPECT_EQ(json["notes"][2]["path"], "masks/p0.png");
}

TEST_F(DataImport, TellsOfTenNotesAndHowManyMore) {
  testing::WriteImageSet(folder_ / "source");
  std::string images;
  for (int i = 0; i < 12; ++i) {
    const std::string name = "a" + std::to_string(i) + ".png";
    perception::WritePng(folder_ / "source" / name, Image(2, 2, 1, static_cast<std::uint8_t>(i)));
    images += (i == 0 ? "" : ", ") + (R"({"id": )" + std::to_string(i)) +
              R"(, "width": 2, "height": 2, "file_name": ")" + name + R"("})";
  }
  WriteFileAtomically(folder_ / "source" / "coco.json",
                      R"({"images": [)" + images +
                          R"(], "annotations": [], "categories": [{"id": 1, "name": "good"}]})");
  const Outcome outcome = RunLine("data import coco " + (folder_ / "source/coco.json").string() +
                                  " --out " + out_.string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 11);
  EXPECT_THAT(outcome.err, HasSubstr("2 more; --json tells all"));
}

TEST_F(DataImport, NamesFilesOnOneLine) {
  testing::WriteImageSet(folder_ / "source");
  std::filesystem::copy_file(folder_ / "source/p0.png", folder_ / "source/line\nend.png");
  const Outcome outcome =
      RunLine("data import folders " + (folder_ / "source").string() +
              " --images . --masks . --mask-suffix _mask --out " + out_.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("line\\nend.png: left out: no mask: expected "));
}

TEST_F(DataImport, TellsOfWhatIsLeftOut) {
  const std::filesystem::path source = folder_ / "source";
  std::filesystem::copy(kTree, source);
  for (const char* name : {"pcd0100cpos.txt", "pcd0110cpos.txt", "pcd0120r.png"}) {
    std::filesystem::remove(source / name);
  }
  const std::string line = "data import cornell " + source.string() + " --split-gap 0 --out ";
  const Outcome outcome = RunLine(line + out_.string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, StartsWith("Wrote 3 images with masks to "));
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("pcd0100r.png: left out, the first of 2: no pcdNNNNcpos.txt of this"),
                    HasSubstr("pcd0120cpos.txt: left out: no pcdNNNNr.png of this number")));
  std::filesystem::remove_all(out_);
  const auto json = nlohmann::json::parse(RunLine(line + out_.string() + " --json").out);
  ASSERT_EQ(json["notes"].size(), 2U);
  EXPECT_EQ(json["notes"][0]["path"], (source / "pcd0100r.png").string());
  EXPECT_EQ(json["notes"][0]["reason"],
            "left out, the first of 2: no pcdNNNNcpos.txt of this number");
}

TEST_F(DataImport, SaysThatTheSourceIsNotThere) {
  for (const char* format : {"folders", "cvat", "coco", "bop"}) {
    const Outcome outcome = RunLine(std::string("data import ") + format + " no/such --out " +
                                    (folder_ / "x").string());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("no/such: no such file or folder")) << format;
  }
}

}  // namespace
}  // namespace handcraft::tools
