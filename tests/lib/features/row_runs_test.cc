// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/row_runs.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::features::internal {
namespace {

using ::testing::ElementsAre;
using Pairs = std::vector<std::pair<int, int>>;

// A mask from rows of text: '#' is wanted.
struct Mask {
  explicit Mask(const std::vector<std::string>& rows)
      : width(static_cast<int>(rows[0].size())), height(static_cast<int>(rows.size())) {
    for (const std::string& row : rows) {
      for (const char c : row) bytes.push_back(c == '#' ? 9 : 0);
    }
  }
  [[nodiscard]] PixelMask View() const { return {bytes.data(), width}; }

  std::vector<std::uint8_t> bytes;
  int width;
  int height;
};

Pairs RunsOf(const Mask& mask, int first_row, int last_row) {
  Pairs runs;
  const RegionBox box{.last_u = mask.width, .last_v = mask.height};
  ForEachRun(mask.View(), box, first_row, last_row, [&](const ColumnRun& run) {
    runs.emplace_back(run.first, run.last);
  });
  return runs;
}

std::string Row(int width, const std::vector<int>& wanted) {
  std::string row(static_cast<std::size_t>(width), '.');
  for (const int u : wanted) row[static_cast<std::size_t>(u)] = '#';
  return row;
}

TEST(ForEachRun, JoinsWhatIsCloseAndPartsWhatIsFar) {
  const Mask mask({Row(100, {3, 5, 28, 60, 84, 99})});
  EXPECT_EQ(RunsOf(mask, 0, 0), (Pairs{{3, 29}, {60, 100}})) << "gaps of 22, 31, 23 and 14";
}

TEST(ForEachRun, PartsAtAGapOfTwentyFour) {
  EXPECT_EQ(RunsOf(Mask({Row(60, {10, 35})}), 0, 0), (Pairs{{10, 11}, {35, 36}}));
  EXPECT_EQ(RunsOf(Mask({Row(60, {10, 34})}), 0, 0), (Pairs{{10, 35}}));
}

TEST(ForEachRun, LooksAtSeveralRowsCutToTheBox) {
  const Mask mask({Row(90, {2}), Row(90, {40}), Row(90, {80})});
  EXPECT_EQ(RunsOf(mask, -4, 0), (Pairs{{2, 3}}));
  EXPECT_EQ(RunsOf(mask, -1, 1), (Pairs{{2, 3}, {40, 41}}));
  EXPECT_EQ(RunsOf(mask, 0, 9), (Pairs{{2, 3}, {40, 41}, {80, 81}}));
  EXPECT_TRUE(RunsOf(mask, 3, 5).empty());
}

TEST(ForEachRun, FindsEveryPixelOfEveryWidth) {
  for (int width = 1; width <= 40; ++width) {
    for (int u = 0; u < width; ++u) {
      EXPECT_EQ(RunsOf(Mask({Row(width, {u})}), 0, 0), (Pairs{{u, u + 1}})) << width;
    }
  }
}

TEST(ForEachPiece, CutsLongRuns) {
  const Mask mask({std::string(300, '#')});
  Pairs pieces;
  ForEachPiece(mask.View(), {.last_u = 300, .last_v = 1}, 0, 0, [&](const ColumnRun& run) {
    pieces.emplace_back(run.first, run.last);
  });
  EXPECT_EQ(pieces, (Pairs{{0, 128}, {128, 256}, {256, 300}}));
}

TEST(BoxOf, IsTheSmallest) {
  const Mask mask({Row(90, {}), Row(90, {40}), Row(90, {}), Row(90, {7, 80}), Row(90, {})});
  const RegionBox box = BoxOf(mask.View(), mask.width, mask.height);
  EXPECT_THAT((std::vector{box.first_u, box.last_u, box.first_v, box.last_v}),
              ElementsAre(7, 81, 1, 4));
  EXPECT_TRUE(BoxOf(Mask({Row(9, {}), Row(9, {})}).View(), 9, 2).empty());
}

// By hand, radius 1: the pixel is in the window of three rows, of one column each.
TEST(SparseWork, CountsColumnsAndRuns) {
  const Mask mask({Row(90, {}), Row(90, {40}), Row(90, {})});
  const RegionBox box = BoxOf(mask.View(), 90, 3);
  EXPECT_EQ(SparseWork(mask.View(), box, 1).num_columns, 3 * (1 + kRunOverhead));
  EXPECT_EQ(SparseWork(mask.View(), box, 1).num_runs, 3);
  EXPECT_EQ(SparseWork(mask.View(), box, 0).num_columns, 1 + kRunOverhead);
  EXPECT_EQ(SparseWork(mask.View(), {}, 0).num_columns, 0);
}

TEST(NumDenseColumns, CountsEveryRowOfEveryStrip) {
  EXPECT_EQ(NumDenseColumns(640, 480, 1), (640 + 5 * kStripOverhead) * 482);
  EXPECT_EQ(NumDenseColumns(129, 1, 0), 129 + 2 * kStripOverhead);
}

// A mask that wants everything is the dense way's, an outline the sparse way's.
TEST(SparseWork, ComesToMoreColumnsThanTheDenseWayForAllPixels) {
  const Mask all(std::vector<std::string>(200, std::string(200, '#')));
  const auto columns = [](const Mask& mask) {
    return SparseWork(mask.View(), BoxOf(mask.View(), mask.width, mask.height), 1).num_columns;
  };
  EXPECT_GE(columns(all), NumDenseColumns(200, 200, 1));
  std::vector<std::string> rows(200, Row(200, {50, 51, 52, 150, 151, 152}));
  EXPECT_LT(columns(Mask(rows)), NumDenseColumns(200, 200, 1) / 3);
}

}  // namespace
}  // namespace handcraft::features::internal
