// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/object_mask.h"

#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;

// One letter a pixel: its brightness, '.' is 0.
Image Draw(const std::vector<std::string>& rows) {
  Image image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      const char letter = rows[static_cast<std::size_t>(v)][static_cast<std::size_t>(u)];
      image.At(u, v) = static_cast<std::uint8_t>(letter == '.' ? 0 : letter - '0');
    }
  }
  return image;
}

std::string MaskOf(const Image& image, std::uint8_t threshold) {
  std::string letters;
  const Image mask = MaskBeforeDarkness(image, threshold);
  for (const std::uint8_t value : mask.values()) {
    letters += value == kObject ? 'X' : value == kNoObject ? '.' : '?';
  }
  return letters;
}

TEST(MaskBeforeDarkness, LeavesDarkPlacesWithinTheObject) {
  const Image image = Draw({"1.....",  //
                            "..999.",
                            "..9.9.",
                            "..999."});
  EXPECT_EQ(MaskOf(image, 0),
            "X....."
            "..XXX."
            "..XXX."
            "..XXX.");
  EXPECT_EQ(MaskOf(image, 1),
            "......"
            "..XXX."
            "..XXX."
            "..XXX.");
  EXPECT_EQ(MaskOf(image, 9), std::string(24, '.'));
}

// Joined by sides: a corner lets nothing through.
TEST(MaskBeforeDarkness, GoesThroughSidesAndNotCorners) {
  EXPECT_EQ(MaskOf(Draw({".9.", "9.9", ".9."}), 0), ".X.XXX.X.");
  EXPECT_EQ(MaskOf(Draw({"...", "9.9", "999"}), 0), "...X.XXXX");
  EXPECT_EQ(MaskOf(Draw({"."}), 0), ".");
}

TEST(MaskBeforeDarkness, LooksAtEveryChannel) {
  Image image(2, 1, 3);
  image.At(1, 0, 2) = 9;
  EXPECT_EQ(MaskOf(image, 8), ".X");
  EXPECT_EQ(MaskOf(image, 9), "..");
}

class ReadObjectMaskTest : public ImporterTest {};

TEST_F(ReadObjectMaskTest, TakesNonzeroForTheObject) {
  WriteImage("a.png", Draw({".19"}));
  EXPECT_EQ(ReadObjectMask(tree_ / "a.png", 3, 1).values(),
            (std::vector<std::uint8_t>{0, 255, 255}));
  EXPECT_THROWS_MESSAGE(ReadObjectMask(tree_ / "a.png", 1, 3),
                        Error,
                        HasSubstr("a.png: the mask is 3x1 pixels, its picture 1x3"));
}

}  // namespace
}  // namespace handcraft::datasets
