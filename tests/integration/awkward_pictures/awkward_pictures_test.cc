// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// What people's folders hold besides plain pictures, taken through check, import, train and predict
// as a user would: each is handled by all of them, or refused by its name.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_image_set.h"
#include "tests/lib/perception/png_builder.h"
#include "tests/support/ink_jpeg.h"
#include "tests/support/turned_jpeg.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

namespace fs = std::filesystem;
using handcraft::testing::ByteVector;
using handcraft::testing::InkCode;
using handcraft::testing::PngBuilder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::RunArgs;

constexpr int kWidth = 64;  // of the pictures of ImageSetTest
constexpr int kHeight = 48;

// Rows that begin with a filter byte, and then the same byte over and over.
ByteVector Rows(std::size_t bytes_a_row, std::uint8_t value) {
  ByteVector rows;
  for (int v = 0; v < kHeight; ++v) {
    rows.push_back(0);
    rows.insert(rows.end(), bytes_a_row, value);
  }
  return rows;
}

void WriteSixteenBit(const fs::path& path) {
  WriteFileAtomically(path, PngBuilder(kWidth, kHeight, 16, 0).Pixels(Rows(2 * kWidth, 7)).End());
}

// All pixels have the second colour of the palette.
void WritePalette(const fs::path& path, const ByteVector& colours) {
  WriteFileAtomically(
      path, PngBuilder(kWidth, kHeight, 8, 3).Chunk("PLTE", colours).Pixels(Rows(kWidth, 1)).End());
}

// The set of ImageSetTest, one file of whose first pair is changed.
class AwkwardPictures : public testing::ImageSetTest {
 protected:
  void SetUp() override {
    ImageSetTest::SetUp();
    testing::TrainGraspPoints(set_, folder_ / "model.safetensors");
  }

  [[nodiscard]] fs::path Picture() const { return set_ / "p0.png"; }
  [[nodiscard]] fs::path Mask() const { return set_ / "p0_mask.png"; }

  [[nodiscard]] Outcome Check() const { return RunArgs({"data", "check", set_.string()}); }

  [[nodiscard]] Outcome Import() const {
    fs::remove_all(folder_ / "imported");
    return RunArgs({"data",
                    "import",
                    "folders",
                    set_.string(),
                    "--images",
                    ".",
                    "--masks",
                    ".",
                    "--mask-suffix",
                    "_mask",
                    "--good",
                    "255",
                    "--dont-care",
                    "128",
                    "--out",
                    (folder_ / "imported").string()});
  }

  [[nodiscard]] Outcome Train() const {
    return RunArgs({"train",
                    "grasp-points",
                    set_.string(),
                    "--features",
                    "filters=laws+edges,window=1,energy=log",
                    "--ridge",
                    "1",
                    "--out",
                    (folder_ / "new.safetensors").string()});
  }

  [[nodiscard]] Outcome Predict(const fs::path& picture) const {
    return RunArgs({"predict",
                    (folder_ / "model.safetensors").string(),
                    picture.string(),
                    "--min-probability",
                    "0.01",
                    "--out",
                    (folder_ / "out").string()});
  }

  // Every command takes the set as it is now.
  void ExpectHandled() const {
    for (const Outcome& outcome : {Check(), Import(), Train()}) {
      EXPECT_EQ(outcome.code, 0) << outcome.err;
    }
  }

  // Every command that reads the file names it and says this.
  void ExpectRefused(const fs::path& file, const std::string& reason) const {
    const Outcome check = Check();
    EXPECT_EQ(check.code, 3);
    EXPECT_THAT(check.out, HasSubstr(file.filename().string() + ": "));
    EXPECT_THAT(check.out, HasSubstr(reason));
    for (const Outcome& outcome : {Import(), Train()}) {
      EXPECT_EQ(outcome.code, 3);
      EXPECT_THAT(outcome.err, HasSubstr(file.filename().string()));
    }
    if (file != Picture()) return;
    const Outcome predict = Predict(file);
    EXPECT_EQ(predict.code, 3);
    EXPECT_THAT(predict.err, HasSubstr("p0.png"));
    EXPECT_THAT(predict.err, HasSubstr(reason));
  }

  // Puts a picture with another name in the place of the first.
  void Rename(const std::string& image) const {
    datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(set_);
    set.items[0].image = image;
    datasets::WriteManifest(set);
  }
};

TEST_F(AwkwardPictures, AJpegThatIsTurnedByItsTagIsTakenAsItIsSeen) {
  fs::remove(Picture());
  handcraft::testing::WriteTurnedJpeg(set_ / "p0.jpg", kHeight, kWidth);  // stored 48 wide
  Rename("p0.jpg");
  EXPECT_EQ(perception::ReadImage(set_ / "p0.jpg").width(), kWidth);
  EXPECT_EQ(Check().code, 0);
  EXPECT_EQ(Import().code, 0);
}

TEST_F(AwkwardPictures, AJpegOfInksBecomesColours) {
  fs::remove(Picture());
  handcraft::testing::WriteInkJpeg(
      set_ / "p0.jpg", kWidth, kHeight, InkCode::kCmyk, {128, 128, 128, 128});
  Rename("p0.jpg");
  ExpectHandled();
  EXPECT_EQ(perception::ReadImage(set_ / "p0.jpg").channels(), 3);
  EXPECT_EQ(Predict(set_ / "p0.jpg").code, 4) << "a picture of one colour has no good place";
}

TEST_F(AwkwardPictures, AJpegOfInksThatNothingExplainsIsRefused) {
  fs::remove(Picture());
  handcraft::testing::WriteInkJpeg(
      set_ / "p0.jpg", kWidth, kHeight, InkCode::kUnmarked, {128, 128, 128, 128});
  Rename("p0.jpg");
  ExpectRefused(set_ / "p0.jpg", "a JPEG of four inks (CMYK) without Adobe's marker");
}

TEST_F(AwkwardPictures, APaletteBecomesColours) {
  WritePalette(Picture(), {0, 0, 0, 10, 200, 30});
  ExpectHandled();
  EXPECT_EQ(perception::ReadImage(Picture()).At(0, 0, 1), 200);
  EXPECT_EQ(Predict(Picture()).code, 0);
}

TEST_F(AwkwardPictures, SixteenBitsAreRefused) {
  WriteSixteenBit(Picture());
  ExpectRefused(Picture(), "a PNG of 16 bits a channel; 8 bits are due");
}

TEST_F(AwkwardPictures, AMaskOfSixteenBitsIsRefused) {
  WriteSixteenBit(Mask());
  ExpectRefused(Mask(), "a PNG of 16 bits a channel; 8 bits are due");
}

TEST_F(AwkwardPictures, AMaskWithAPaletteIsTakenWhereItIsGray) {
  WritePalette(Mask(), {0, 0, 0, 255, 255, 255});
  for (const Outcome& outcome : {Check(), Import(), Train()}) EXPECT_EQ(outcome.code, 0);
  WritePalette(Mask(), {0, 0, 0, 255, 0, 0});
  ExpectRefused(Mask(), "a palette of colours where a gray one is due");
}

TEST_F(AwkwardPictures, AMaskOfAnotherSizeIsRefused) {
  perception::WritePng(Mask(), Image(kWidth - 1, kHeight));
  ExpectRefused(Mask(), "the mask is 63x48 pixels, its picture 64x48");
}

TEST_F(AwkwardPictures, AnEmptyMaskIsNotedByAllThatReadIt) {
  perception::WritePng(Mask(), Image(kWidth, kHeight));
  ExpectHandled();
  EXPECT_THAT(Check().out, HasSubstr("p0_mask.png: note: no good pixel"));
  EXPECT_THAT(Import().err, HasSubstr("masks/p0.png: no good pixel"));
  EXPECT_THAT(Train().err, HasSubstr("left out: p0.png, no good pixel"));
}

TEST_F(AwkwardPictures, EmptyFilesAreRefused) {
  for (const fs::path& file : {Picture(), Mask()}) {
    const std::vector<std::uint8_t> before = ReadFile(file);
    WriteFileAtomically(file, "");
    ExpectRefused(file, "the file is empty");
    WriteFileAtomically(file, before);
  }
}

TEST_F(AwkwardPictures, MissingFilesAreNamed) {
  for (const fs::path& file : {Picture(), Mask()}) {
    const std::vector<std::uint8_t> before = ReadFile(file);
    fs::remove(file);
    EXPECT_THAT(Check().out,
                HasSubstr(file.filename().string() + ": cannot open: No such file or directory"));
    EXPECT_THAT(Import().err, HasSubstr("p0"));
    EXPECT_THAT(Train().err, HasSubstr(file.filename().string() + ": cannot open"));
    if (file == Picture()) {
      EXPECT_THAT(Predict(file).err, HasSubstr("p0.png: cannot open"));
    }
    WriteFileAtomically(file, before);
  }
}

TEST_F(AwkwardPictures, AFolderWhereAFileIsDueIsNamed) {
  fs::create_directory(set_ / "things");
  datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(set_);
  for (const std::string_view column : datasets::kCompanions) {
    set.items[0].others = {{std::string(column), "things"}};
    datasets::WriteManifest(set);
    const Outcome check = Check();
    EXPECT_EQ(check.code, 3) << column;
    EXPECT_THAT(check.out, HasSubstr("things: cannot read: Is a directory (give a file in it)"));
  }
}

TEST_F(AwkwardPictures, UnusualNamesAreKept) {
  const std::string name = "größe 1, \"ü\" 'x'\n\t#%&;(1)";
  datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(set_);
  set.items[0].image = name + ".png";
  set.items[0].mask = name + "_mask.png";
  set.items[0].object_class = "Täse,\t\"groß\"";
  fs::rename(Picture(), set_ / set.items[0].image);
  fs::rename(Mask(), set_ / set.items[0].mask);
  datasets::WriteManifest(set);
  EXPECT_EQ(datasets::ReadLabelledImageSet(set_).items, set.items);
  ExpectHandled();
  EXPECT_TRUE(fs::exists(folder_ / "imported" / "images" / set.items[0].image));
  EXPECT_EQ(Predict(set_ / set.items[0].image).code, 0);
  const Outcome info = RunArgs({"data", "info", set_.string()});
  EXPECT_THAT(info.out, HasSubstr("Täse,\\t\"groß\"")) << "a tab would break the table";
  EXPECT_THAT(info.out, Not(HasSubstr("\t")));
}

TEST_F(AwkwardPictures, UnusualNamesStandOnOneLineOfAMessage) {
  datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(set_);
  set.items[0].image = "line\nend.png";
  datasets::WriteManifest(set);
  EXPECT_THAT(Check().out, HasSubstr("line\\nend.png: cannot open"));
  EXPECT_THAT(Train().err, HasSubstr("line\\nend.png: cannot open"));
}

}  // namespace
}  // namespace handcraft::tools
