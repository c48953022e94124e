// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/mask_picture.h"

#include <array>

#include "datasets/formats/organised_cloud.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

constexpr std::array<MaskValue, 3> kValues = {{{7, "seven"}, {0, "none"}, {9, "nine"}}};

TEST(ReadMaskPicture, KeepsTheValuesThatAreDue) {
  const TemporaryDirectory folder;
  Image mask(3, 2, 1, 7);
  mask.At(2, 1) = 9;
  mask.At(0, 1) = 0;
  perception::WritePng(folder / "m.png", mask);
  EXPECT_EQ(ReadMaskPicture(folder / "m.png", kValues).values(), mask.values());
}

TEST(ReadMaskPicture, NamesTheFirstOtherValue) {
  const TemporaryDirectory folder;
  Image mask(3, 2, 1, 7);
  mask.At(1, 1) = 8;
  mask.At(2, 1) = 6;
  perception::WritePng(folder / "m.png", mask);
  EXPECT_THROWS_MESSAGE(ReadMaskPicture(folder / "m.png", kValues),
                        Error,
                        HasSubstr("m.png: value 8 at column 1, row 1; 7 (seven), 0 (none) or 9 "
                                  "(nine) is due (save the mask without smoothing, as PNG)"));
  EXPECT_THROWS_MESSAGE(
      ReadMaskPicture(folder / "no.png", kValues), Error, HasSubstr("no.png: cannot open"));
  WriteFileAtomically(folder / "m.png", "");
  EXPECT_THROWS_MESSAGE(
      ReadMaskPicture(folder / "m.png", kValues), Error, HasSubstr("the file is empty"));
}

TEST(ReadObjectMask, TakesItsTwoValuesAlone) {
  const TemporaryDirectory folder;
  Image mask(3, 2, 1, kObject);
  mask.At(1, 0) = kNoObject;
  perception::WritePng(folder / "m.png", mask);
  EXPECT_EQ(ReadObjectMask(folder / "m.png").values(), mask.values());
  mask.At(1, 0) = 128;
  perception::WritePng(folder / "m.png", mask);
  EXPECT_THROWS_MESSAGE(
      ReadObjectMask(folder / "m.png"),
      Error,
      HasSubstr("value 128 at column 1, row 0; 255 (object) or 0 (something else) is due"));
}

TEST(SizeOf, IsWidthThenHeight) {
  EXPECT_EQ(SizeOf(Image(3, 2)), (PixelSize{3, 2}));
  EXPECT_EQ(SizeOf(OrganisedCloud{.width = 4, .height = 5}), (PixelSize{4, 5}));
}

TEST(RequireSameSize, SaysBothSizes) {
  RequireSameSize("a.png", "the mask", {3, 2}, {3, 2});
  EXPECT_THROWS_MESSAGE((RequireSameSize("a.png", "the mask", {3, 2}, {2, 3}), 0),
                        Error,
                        HasSubstr("a.png: the mask is 3x2 pixels, its picture 2x3"));
}

}  // namespace
}  // namespace handcraft::datasets
