// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/image_header.h"

#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/lib/perception/png_builder.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/ink_jpeg.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::perception {
namespace {

using ::testing::AllOf;
using testing::ByteVector;
using ::testing::HasSubstr;
using testing::PngBuilder;

ByteVector Encoded(const std::string& extension, int type) {
  const cv::Mat pixels(5, 7, type, cv::Scalar(10, 120, 200, 255));
  ByteVector bytes;
  cv::imencode(extension, pixels, bytes);
  return bytes;
}

ByteVector Text(std::string_view text) { return {text.begin(), text.end()}; }

ImageHeader Read(const ByteVector& bytes) { return ReadImageHeader("file", bytes); }

ByteVector TinyPng() { return PngBuilder(2, 1, 8, 0).Pixels({0, 10, 20}).End(); }

TEST(ReadImageHeader, SeesSizeAndKindOfEveryFormat) {
  struct Case {
    const char* extension;
    int type;
    const char* format;
    bool gray;
  };
  for (const Case& expected : {Case{".png", CV_8UC1, "PNG", true},
                               Case{".png", CV_8UC3, "PNG", false},
                               Case{".png", CV_8UC4, "PNG", false},
                               Case{".jpg", CV_8UC1, "JPEG", true},
                               Case{".jpg", CV_8UC3, "JPEG", false},
                               Case{".bmp", CV_8UC1, "BMP", false},
                               Case{".bmp", CV_8UC3, "BMP", false},
                               Case{".pgm", CV_8UC1, "PGM", true},
                               Case{".ppm", CV_8UC3, "PPM", false}}) {
    SCOPED_TRACE(expected.extension);
    const ImageHeader header = Read(Encoded(expected.extension, expected.type));
    EXPECT_EQ(header.format, expected.format);
    EXPECT_EQ(header.width, 7);
    EXPECT_EQ(header.height, 5);
    EXPECT_EQ(header.gray, expected.gray);
  }
}

TEST(ReadImageHeader, SeesAPaletteAsColour) {
  EXPECT_FALSE(Read(PngBuilder(1, 1, 8, 3).Chunk("PLTE", {1, 2, 3}).Pixels({0, 0}).End()).gray);
}

TEST(ReadImageHeader, SeesGrayWithAlphaAsGray) {
  EXPECT_TRUE(Read(PngBuilder(1, 1, 8, 4).Pixels({0, 9, 255}).End()).gray);
}

TEST(ReadImageHeader, SeesThatARotationTagMayTurnThePicture) {
  const testing::TemporaryDirectory folder;
  testing::WriteTurnedJpeg(folder / "turned.jpg", 32, 16);
  const ImageHeader header = Read(ReadFile(folder / "turned.jpg"));
  EXPECT_EQ(header.width, 32);
  EXPECT_TRUE(header.may_turn);
  EXPECT_FALSE(Read(Encoded(".jpg", CV_8UC3)).may_turn);
  EXPECT_TRUE(Read(PngBuilder(1, 1, 8, 0).Chunk("eXIf", {1}).Pixels({0, 9}).End()).may_turn);
  EXPECT_FALSE(Read(TinyPng()).may_turn);
}

// Law: whatever the format, no file loses its last bytes unnoticed.
TEST(ReadImageHeader, RefusesEveryTruncation) {
  for (const char* extension : {".png", ".jpg", ".bmp", ".pgm", ".ppm"}) {
    SCOPED_TRACE(extension);
    const bool gray = std::string_view(extension) == ".pgm";
    const ByteVector whole = Encoded(extension, gray ? CV_8UC1 : CV_8UC3);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const ByteVector part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_THROW(static_cast<void>(Read(part)), Error) << size << " of " << whole.size();
    }
  }
}

TEST(ReadImageHeader, RefusesEveryFlippedBitOfAPng) {
  const ByteVector whole = TinyPng();
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    ByteVector flipped = whole;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    EXPECT_THROW(static_cast<void>(Read(flipped)), Error) << "bit " << bit;
  }
}

TEST(ReadImageHeader, AcceptsBytesBehindTheEnd) {
  for (const char* extension : {".png", ".jpg", ".bmp"}) {
    ByteVector bytes = Encoded(extension, CV_8UC3);
    bytes.resize(bytes.size() + 100, 0xAB);
    EXPECT_EQ(Read(bytes).width, 7) << extension;
  }
}

TEST(ReadImageHeader, NamesWhatIsWrongAndWhere) {
  EXPECT_THROWS_MESSAGE(Read({}), Error, HasSubstr("file: the file is empty"));
  EXPECT_THROWS_MESSAGE(Read(Text("hello")), Error, HasSubstr("file: not a picture; an 8-bit PNG"));
  EXPECT_THROWS_MESSAGE(Read(Encoded(".tiff", CV_32FC1)), Error, HasSubstr("a TIFF file"));
  EXPECT_THROWS_MESSAGE(Read(Encoded(".png", CV_16UC1)),
                        Error,
                        HasSubstr("a PNG of 16 bits a channel; 8 bits are due"));
  EXPECT_THROWS_MESSAGE(Read(Encoded(".pgm", CV_16UC1)), Error, HasSubstr("16 bits a channel"));
  EXPECT_THROWS_MESSAGE(Read(Text("P5 1 1 100\nx")), Error, HasSubstr("largest value of 100"));
  EXPECT_THROWS_MESSAGE(Read(Text("P5 1 x 255\nx")), Error, HasSubstr("a number is due"));
  EXPECT_THROWS_MESSAGE(Read(Text("P2 1 1 255 0")), Error, HasSubstr("PGM file in text form"));
  ByteVector cut = TinyPng();
  cut.pop_back();
  EXPECT_THROWS_MESSAGE(Read(cut), Error, HasSubstr("the file is cut off here"));
  ByteVector damaged = TinyPng();
  damaged[45] ^= 1U;  // inside the second chunk, which begins at byte 33
  EXPECT_THROWS_MESSAGE(Read(damaged), Error, AllOf(HasSubstr("33"), HasSubstr("checksum")));
}

TEST(ReadImageHeader, RefusesInksThatNothingExplains) {
  const testing::TemporaryDirectory folder;
  const auto read = [&](testing::InkCode code) {
    testing::WriteInkJpeg(folder / "inks.jpg", 8, 8, code, {128, 128, 128, 128});
    return Read(ReadFile(folder / "inks.jpg"));
  };
  EXPECT_FALSE(read(testing::InkCode::kCmyk).gray);
  EXPECT_FALSE(read(testing::InkCode::kYcck).gray);
  EXPECT_THROWS_MESSAGE(read(testing::InkCode::kUnmarked),
                        Error,
                        AllOf(HasSubstr("file at byte 80: a JPEG of four inks"),
                              HasSubstr("without Adobe's marker"),
                              HasSubstr("(convert it to RGB)")));
  for (const int unknown : {1, 7}) {
    EXPECT_THROWS_MESSAGE(read(static_cast<testing::InkCode>(unknown)),
                          Error,
                          HasSubstr("without Adobe's marker of CMYK or YCCK"));
  }
}

TEST(ReadImageHeader, RefusesAJpegOfTwoChannels) {
  const testing::TemporaryDirectory folder;
  testing::WriteInkJpeg(
      folder / "two.jpg", 8, 8, testing::InkCode::kUnmarked, {128, 128, 128, 128});
  ByteVector bytes = ReadFile(folder / "two.jpg");
  bytes[80] = 2;
  EXPECT_THROWS_MESSAGE(Read(bytes), Error, HasSubstr("a JPEG of 2 channels; 1, 3 or 4 are due"));
}

TEST(ReadImageHeader, RefusesAbsurdSizes) {
  const auto read = [](std::uint32_t width, std::uint32_t height) {
    return Read(PngBuilder(width, height, 8, 0).Pixels({0}).End());
  };
  EXPECT_THROWS_MESSAGE(read(0, 5), Error, HasSubstr("0x5 pixels; at least 1x1"));
  EXPECT_THROWS_MESSAGE(read(65536, 1), Error, HasSubstr("65536x1 pixels; at most 65535 a side"));
  EXPECT_THROWS_MESSAGE(read(60000, 60000), Error, HasSubstr("268435456 in all"));
  EXPECT_THROWS_MESSAGE(read(0xFFFFFFFFU, 0xFFFFFFFFU), Error, HasSubstr("4294967295x4294967295"));
  EXPECT_EQ(read(65535, 1).width, 65535);
  EXPECT_THROWS_MESSAGE(
      Read(Text("P5 99999999999999999999 1 255\n")), Error, HasSubstr("at most 65535"));
}

}  // namespace
}  // namespace handcraft::perception
