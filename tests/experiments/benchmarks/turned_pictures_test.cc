// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/turned_pictures.h"

#include <algorithm>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "datasets/labelled_image_faults.h"
#include "lib/perception/image_io.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

// 1 2 3
// 4 5 6
Image SixPixels() {
  Image image(3, 2);
  for (int i = 0; i < 6; ++i) image.Row(i / 3)[i % 3] = static_cast<std::uint8_t>(i + 1);
  return image;
}

TEST(Turn, MirrorsAndSwaps) {
  using Values = std::vector<std::uint8_t>;
  EXPECT_EQ(Turn(SixPixels(), 0).values(), (Values{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(Turn(SixPixels(), 1).values(), (Values{3, 2, 1, 6, 5, 4}));
  EXPECT_EQ(Turn(SixPixels(), 2).values(), (Values{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(Turn(SixPixels(), 4).values(), (Values{1, 4, 2, 5, 3, 6}));
  EXPECT_EQ(Turn(SixPixels(), 4).width(), 2);
}

TEST(Turn, GivesEightDifferentPictures) {
  std::set<std::pair<int, std::vector<std::uint8_t>>> seen;
  for (int turn = 0; turn < kNumTurns; ++turn) {
    const Image image = Turn(SixPixels(), turn);
    seen.insert({image.width(), image.values()});
  }
  EXPECT_EQ(seen.size(), 8U);
}

TEST(WriteTurnedPictures, StopsWhenThereAreGoodPixelsEnough) {
  const testing::TemporaryDirectory folder;
  Image image(5, 4, 3, 90);
  image.At(1, 1) = 7;  // no symmetry
  perception::WritePng(folder / "image.png", image);
  Image mask(5, 4, 1, datasets::kMaskBad);
  std::fill_n(mask.Row(0), 5, datasets::kMaskGood);
  perception::WritePng(folder / "mask.png", mask);
  const datasets::LabelledImageSet set{folder.path(),
                                       {{"image.png", "mask.png", "thing", "1", "train", "none"}}};
  const auto count = [&](std::size_t num_good) {
    const testing::TemporaryDirectory out;
    const auto turned = WriteTurnedPictures(set, num_good, out.path());
    for (const datasets::Fault& fault : datasets::FindFaults(turned)) {
      ADD_FAILURE() << fault.path << ": " << fault.reason;
    }
    return turned.items.size();
  };
  EXPECT_EQ(count(5), 1U);
  EXPECT_EQ(count(6), 2U);
  EXPECT_EQ(count(1000), 8U);
}

}  // namespace
}  // namespace handcraft::experiments
