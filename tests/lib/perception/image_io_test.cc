// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/image_io.h"

#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/lib/perception/png_builder.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/ink_jpeg.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::perception {
namespace {

using testing::ByteVector;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::PngBuilder;

Image RandomImage(int width, int height, int channels, std::uint64_t seed) {
  Image image(width, height, channels);
  Rng rng(seed);
  for (int v = 0; v < height; ++v) {
    for (int i = 0; i < width * channels; ++i) {
      image.Row(v)[i] = static_cast<std::uint8_t>(rng.UniformInt(256));
    }
  }
  return image;
}

Image ReadBytes(const ByteVector& bytes, Channels channels = Channels::kAsStored) {
  const testing::TemporaryDirectory folder;
  std::ofstream(folder / "picture", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  return ReadImage(folder / "picture", channels);
}

TEST(ReadImage, KeepsTheOrderBlueGreenRed) {
  // Colour type 2: red, green, blue.
  const Image image = ReadBytes(PngBuilder(2, 1, 8, 2).Pixels({0, 1, 2, 3, 4, 5, 6}).End());
  EXPECT_EQ(image.channels(), 3);
  EXPECT_THAT(image.values(), ElementsAre(3, 2, 1, 6, 5, 4));
}

TEST(ReadImage, TurnsAPaletteIntoColours) {
  const Image image = ReadBytes(
      PngBuilder(2, 1, 8, 3).Chunk("PLTE", {10, 20, 30, 40, 50, 60}).Pixels({0, 1, 0}).End());
  EXPECT_EQ(image.channels(), 3);
  EXPECT_THAT(image.values(), ElementsAre(60, 50, 40, 30, 20, 10));
}

TEST(ReadImage, TakesAPaletteOfGraysForGray) {
  const ByteVector grays = {0, 0, 0, 128, 128, 128, 255, 255, 255, 9, 8, 7};
  const auto picture = [&](std::uint8_t last) {
    return PngBuilder(3, 1, 8, 3).Chunk("PLTE", grays).Pixels({0, 2, 1, last}).End();
  };
  const Image gray = ReadBytes(picture(0), Channels::kGray);
  EXPECT_EQ(gray.channels(), 1);
  EXPECT_THAT(gray.values(), ElementsAre(255, 128, 0));
  EXPECT_EQ(ReadBytes(picture(0)).channels(), 3);
  EXPECT_THROWS_MESSAGE(ReadBytes(picture(3), Channels::kGray),
                        Error,
                        HasSubstr("a palette of colours where a gray one is due (save it as gray "
                                  "values, without a palette)"));
}

TEST(ReadImage, RefusesAnIndexBeyondThePalette) {
  EXPECT_THROWS_MESSAGE(
      ReadBytes(
          PngBuilder(2, 1, 8, 3).Chunk("PLTE", {10, 20, 30, 40, 50, 60}).Pixels({0, 1, 7}).End()),
      Error,
      HasSubstr("damaged PNG: pixel (1, 0) has palette index 7, but the palette "
                "has 2 colours"));
}

TEST(ReadImage, DropsAlpha) {
  const Image colour = ReadBytes(PngBuilder(1, 1, 8, 6).Pixels({0, 1, 2, 3, 77}).End());
  EXPECT_THAT(colour.values(), ElementsAre(3, 2, 1));
  const Image gray = ReadBytes(PngBuilder(2, 1, 8, 4).Pixels({0, 9, 255, 8, 0}).End());
  EXPECT_EQ(gray.channels(), 1);
  EXPECT_THAT(gray.values(), ElementsAre(9, 8));
}

TEST(ReadImage, SpreadsFewBitsOverTheRange) {
  const Image image = ReadBytes(PngBuilder(4, 1, 1, 0).Pixels({0, 0b10100000}).End());
  EXPECT_THAT(image.values(), ElementsAre(255, 0, 255, 0));
}

TEST(ReadImage, AppliesTheRotationTag) {
  const testing::TemporaryDirectory folder;
  testing::WriteTurnedJpeg(folder / "turned.jpg", 32, 16);
  const Image image = ReadImage(folder / "turned.jpg");
  ASSERT_EQ(image.width(), 16);
  ASSERT_EQ(image.height(), 32);
  EXPECT_GT(image.At(8, 4), 240);
  EXPECT_LT(image.At(8, 28), 15);
}

// Adversary: the standard knows the tags 1 to 8.
TEST(ReadImage, TakesAnUnknownRotationTagForNone) {
  const testing::TemporaryDirectory folder;
  for (const std::uint16_t orientation : std::array<std::uint16_t, 3>{0, 9, 65535}) {
    testing::WriteTurnedJpeg(folder / "turned.jpg", 32, 16, orientation);
    const Image image = ReadImage(folder / "turned.jpg");
    ASSERT_EQ(image.width(), 32) << orientation;
    ASSERT_EQ(image.height(), 16) << orientation;
    EXPECT_GT(image.At(4, 8), 240) << orientation;
    EXPECT_LT(image.At(28, 8), 15) << orientation;
  }
}

// What a pixel with these inks looks like, 255 for none of an ink: Adobe's programs write them so.
std::array<double, 3> BlueGreenRed(const std::array<double, 4>& inks) {
  const double black = inks[3] / 255.0;
  return {inks[2] * black, inks[1] * black, inks[0] * black};
}

void ExpectInks(testing::InkCode code,
                const std::array<int, 4>& stored,
                const std::array<double, 4>& inks) {
  const testing::TemporaryDirectory folder;
  testing::WriteInkJpeg(folder / "inks.jpg", 24, 16, code, stored);
  const Image image = ReadImage(folder / "inks.jpg");
  ASSERT_EQ(image.width(), 24);
  ASSERT_EQ(image.channels(), 3);
  const std::array<double, 3> expected = BlueGreenRed(inks);
  for (const int u : {0, 23}) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(image.At(u, 9, static_cast<int>(c)), expected[c], 2.0) << u << ' ' << c;
    }
  }
}

TEST(ReadImage, TurnsAdobesInksIntoColours) {
  ExpectInks(testing::InkCode::kCmyk, {228, 30, 128, 210}, {228, 30, 128, 210});
  ExpectInks(testing::InkCode::kCmyk, {255, 255, 255, 255}, {255, 255, 255, 255});
  ExpectInks(testing::InkCode::kCmyk, {255, 255, 255, 1}, {255, 255, 255, 1});
}

TEST(ReadImage, TurnsAdobesLumaAndChromaOfInksIntoColours) {
  // ITU-T T.871: red = Y + 1.402 (Cr - 128) and so on; cyan is 255 less that.
  ExpectInks(testing::InkCode::kYcck, {200, 128, 128, 220}, {55, 55, 55, 220});
  ExpectInks(testing::InkCode::kYcck,
             {128, 64, 192, 255},
             {255 - 128 - 1.402 * 64,
              255 - 128 - 0.344136 * 64 + 0.714136 * 64,
              255 - 128 + 1.772 * 64,
              255});
}

TEST(ReadImage, ReadsWhatWasWritten) {
  const testing::TemporaryDirectory folder;
  const std::filesystem::path path = folder / "Käfer & \"Co\" 象.png";
  int seed = 1;
  for (const auto& [width, height] : {std::pair{1, 1}, {4, 4}, {10000, 3}, {3, 1000}, {64, 48}}) {
    for (const int channels : {1, 3}) {
      const Image image = RandomImage(width, height, channels, static_cast<std::uint64_t>(++seed));
      WritePng(path, image);
      const Image read = ReadImage(path);
      EXPECT_EQ(read.width(), width);
      EXPECT_EQ(read.channels(), channels);
      EXPECT_EQ(read.values(), image.values());
    }
  }
}

TEST(ReadImage, RefusesColourWhereGrayIsDue) {
  EXPECT_THROWS_MESSAGE(
      ReadBytes(PngBuilder(1, 1, 8, 2).Pixels({0, 1, 2, 3}).End(), Channels::kGray),
      Error,
      HasSubstr("picture: a colour picture where a gray one is due"));
}

TEST(ReadImage, NamesTheFileAtFault) {
  EXPECT_THROWS_MESSAGE(ReadImage("no/such.png"), Error, HasSubstr("no/such.png: cannot open"));
  EXPECT_THROWS_MESSAGE(
      ReadBytes(PngBuilder(1, 1, 16, 0).Pixels({0, 1, 2}).End()), Error, HasSubstr("16 bits"));
  // Sound chunks round a picture that is not: the decoder is the one to notice.
  EXPECT_THROWS_MESSAGE(ReadBytes(PngBuilder(5, 5, 8, 0).Chunk("IDAT", {1, 2, 3}).End()),
                        Error,
                        HasSubstr("a damaged PNG that cannot be decoded"));
  EXPECT_THROWS_MESSAGE(ReadBytes(PngBuilder(5, 5, 8, 0).End()), Error, HasSubstr("no pixels"));
}

// Law: a damaged file is an Error or a picture, never another exception.
TEST(ReadImage, SurvivesFlippedBits) {
  const testing::TemporaryDirectory folder;
  const Image image = RandomImage(24, 16, 3, 7);
  const cv::Mat pixels(16, 24, CV_8UC3, const_cast<std::uint8_t*>(image.Row(0)));
  for (const char* extension : {".bmp", ".ppm"}) {  // headers of up to 54 bytes
    ByteVector whole;
    cv::imencode(extension, pixels, whole);
    for (std::size_t bit = 0; bit < 432; ++bit) {
      ByteVector flipped = whole;
      flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      try {
        const Image read = ReadBytes(flipped);
        EXPECT_TRUE(read.channels() == 1 || read.channels() == 3) << extension << " bit " << bit;
        EXPECT_FALSE(read.empty()) << extension << " bit " << bit;
      } catch (const Error& error) {
        EXPECT_EQ(error.details().kind, Error::Kind::kBadInput) << extension << " bit " << bit;
      }
    }
  }
}

TEST(WritePng, WritesTheSameBytesTwice) {
  const testing::TemporaryDirectory folder;
  const Image image = RandomImage(50, 40, 3, 3);
  WritePng(folder / "a.png", image);
  WritePng(folder / "b.png", image);
  EXPECT_EQ(ReadFile(folder / "a.png"), ReadFile(folder / "b.png"));
}

TEST(WritePng, RefusesWhatIsNoPicture) {
  EXPECT_THROW(WritePng("x.png", Image()), std::logic_error);
  EXPECT_THROW(WritePng("x.png", Image(2, 2, 2)), std::logic_error);
  EXPECT_THROWS_MESSAGE(WritePng("no/x.png", Image(1, 1)), Error, HasSubstr("no/x.png"));
}

TEST(WritePng16, KeepsAllBits) {
  const testing::TemporaryDirectory folder;
  BasicImage<std::uint16_t> depth(3, 2);
  depth.At(1, 0) = 65535;
  depth.At(2, 1) = 258;
  WritePng16(folder / "depth.png", depth);
  const cv::Mat read = cv::imread((folder / "depth.png").string(), cv::IMREAD_UNCHANGED);
  ASSERT_EQ(read.type(), CV_16U);
  for (int v = 0; v < 2; ++v) {
    for (int u = 0; u < 3; ++u) EXPECT_EQ(read.at<std::uint16_t>(v, u), depth.At(u, v));
  }
  EXPECT_THROWS_MESSAGE(ReadImage(folder / "depth.png"), Error, HasSubstr("16 bits"));
  EXPECT_THROW(WritePng16("x.png", BasicImage<std::uint16_t>(2, 2, 3)), std::logic_error);
}

TEST(ReadImage16, ReadsWhatIsWritten) {
  const testing::TemporaryDirectory folder;
  BasicImage<std::uint16_t> depth(7, 5);
  Rng rng(5);
  for (int v = 0; v < 5; ++v) {
    for (int u = 0; u < 7; ++u) depth.At(u, v) = static_cast<std::uint16_t>(rng.UniformInt(65536));
  }
  WritePng16(folder / "depth.png", depth);
  EXPECT_EQ(ReadImage16(folder / "depth.png").values(), depth.values());

  // PGM keeps the high byte first.
  WriteFileAtomically(folder / "depth.pgm", std::string("P5 2 1 65535\n\x01\x02\xFF\x00", 17));
  const BasicImage<std::uint16_t> pgm = ReadImage16(folder / "depth.pgm");
  EXPECT_EQ(pgm.At(0, 0), 258);
  EXPECT_EQ(pgm.At(1, 0), 65280);
}

TEST(ReadImage16, RefusesPicturesOfOtherKinds) {
  const testing::TemporaryDirectory folder;
  WritePng(folder / "8.png", Image(3, 2));
  EXPECT_THROWS_MESSAGE(ReadImage16(folder / "8.png"),
                        Error,
                        HasSubstr("8.png at byte 24: a PNG of 8 bits a channel; 16 bits are due"));
  cv::imwrite((folder / "colour.png").string(), cv::Mat(2, 3, CV_16UC3, cv::Scalar(1, 2, 3)));
  EXPECT_THROWS_MESSAGE(ReadImage16(folder / "colour.png"), Error, HasSubstr("a colour picture"));
  cv::imwrite((folder / "8.jpg").string(), cv::Mat(2, 3, CV_8U, cv::Scalar(1)));
  EXPECT_THROWS_MESSAGE(ReadImage16(folder / "8.jpg"), Error, HasSubstr("16 bits are due"));
  cv::imwrite((folder / "8.bmp").string(), cv::Mat(2, 3, CV_8U, cv::Scalar(1)));
  EXPECT_THROWS_MESSAGE(ReadImage16(folder / "8.bmp"), Error, HasSubstr("16 bits are due"));
  WriteFileAtomically(folder / "short.pgm", std::string("P5 2 1 65535\n\x01\x02\xFF", 16));
  EXPECT_THROWS_MESSAGE(ReadImage16(folder / "short.pgm"), Error, HasSubstr("cut off"));
  WriteFileAtomically(folder / "depth.tif", std::string("II*\0", 4));
  EXPECT_THROWS_MESSAGE(ReadImage16(folder / "depth.tif"),
                        Error,
                        HasSubstr("a TIFF file; a 16-bit PNG or PGM is due"));
}

TEST(RawView, SeesTheSamePixels) {
  const Image gray = RandomImage(5, 4, 1, 1);
  EXPECT_EQ(RawView(gray).format, features::PixelFormat::kGray8);
  EXPECT_EQ(RawView(gray).stride_bytes, 5);
  const Image colour = RandomImage(5, 4, 3, 1);
  const features::RawImage view = RawView(colour);
  EXPECT_EQ(view.format, features::PixelFormat::kBgr8);
  EXPECT_EQ(view.width, 5);
  EXPECT_EQ(view.height, 4);
  EXPECT_EQ(view.data[3 * view.stride_bytes + 14], colour.At(4, 3, 2));
}

}  // namespace
}  // namespace handcraft::perception
