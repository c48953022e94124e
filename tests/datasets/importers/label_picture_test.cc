// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/label_picture.h"

#include <sys/stat.h>

#include <opencv2/imgcodecs.hpp>

#include "lib/core/error.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_image_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NoiseImage;
using testing::TemporaryDirectory;

TEST(ReadLabelValues, ReadsGrayValues) {
  const TemporaryDirectory folder;
  const Image labels = NoiseImage(9, 7, 1, 1);
  perception::WritePng(folder / "a.png", labels);
  EXPECT_EQ(ReadLabelValues(folder / "a.png").values(), labels.values());
}

TEST(ReadLabelValues, TakesEqualChannelsAndNoColour) {
  const TemporaryDirectory folder;
  const Image labels = NoiseImage(9, 7, 1, 2);
  Image colour(9, 7, 3);
  for (int v = 0; v < 7; ++v) {
    for (int i = 0; i < 27; ++i) colour.Row(v)[i] = labels.At(i / 3, v);
  }
  perception::WritePng(folder / "a.png", colour);
  EXPECT_EQ(ReadLabelValues(folder / "a.png").values(), labels.values());
  EXPECT_EQ(ReadLabelPicture(folder / "a.png").channels(), 3);
  colour.At(4, 5, 1) = static_cast<std::uint8_t>(colour.At(4, 5, 1) + 1);
  perception::WritePng(folder / "a.png", colour);
  EXPECT_THROWS_MESSAGE(
      ReadLabelValues(folder / "a.png"),
      Error,
      AllOf(HasSubstr("a.png: a colour at column 4, row 5"), HasSubstr("without a palette")));
}

TEST(ReadLabelValues, RefusesJpegAndSixteenBit) {
  const TemporaryDirectory folder;
  testing::WriteTurnedJpeg(folder / "a.png", 8, 6);  // whatever its name
  EXPECT_THROWS_MESSAGE(
      ReadLabelValues(folder / "a.png"), Error, HasSubstr("a.png: labels in a JPEG"));
  cv::imwrite((folder / "deep.png").string(), cv::Mat(4, 4, CV_16UC1, cv::Scalar(1)));
  EXPECT_THROWS_MESSAGE(ReadLabelValues(folder / "deep.png"), Error, HasSubstr("16"));
  EXPECT_THROWS_MESSAGE(ReadLabelValues(folder / "no.png"), Error, HasSubstr("no.png"));
}

TEST(ReadLabelPicture, DoesNotWaitForAPipe) {
  const TemporaryDirectory folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  EXPECT_THROWS_MESSAGE(static_cast<void>(ReadLabelPicture(folder / "pipe.png")),
                        Error,
                        HasSubstr("pipe.png: is a pipe or a device; a file is due"));
}

}  // namespace
}  // namespace handcraft::datasets
