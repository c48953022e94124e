// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/position_tree.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::features {
namespace {

struct OwnedTree {
  std::vector<double> rows = {};
  std::vector<std::int32_t> numbers = {};

  explicit OwnedTree(const std::vector<Vector3>& positions) {
    for (const std::size_t i : TreeOrder(positions)) {
      rows.insert(rows.end(), positions[i].begin(), positions[i].end());
      numbers.push_back(static_cast<std::int32_t>(i));
    }
  }
  [[nodiscard]] PositionTree View() const { return {rows, numbers}; }
};

// Few different coordinates, so that there are ties.
std::vector<Vector3> SomePositions(std::size_t count, Rng& rng, bool on_grid) {
  std::vector<Vector3> positions(count);
  for (Vector3& p : positions) {
    for (double& x : p) x = on_grid ? static_cast<double>(rng.UniformInt(6)) : rng.Normal();
  }
  return positions;
}

std::vector<Neighbour> ByBruteForce(const std::vector<Vector3>& positions,
                                    const Vector3& point,
                                    std::size_t count) {
  std::vector<Neighbour> all;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double x = positions[i][0] - point[0];
    const double y = positions[i][1] - point[1];
    const double z = positions[i][2] - point[2];
    all.push_back({x * x + y * y + z * z, static_cast<std::int32_t>(i), 0});
  }
  std::sort(all.begin(), all.end(), [](const Neighbour& a, const Neighbour& b) {
    return a.squared_distance_m2 != b.squared_distance_m2
               ? a.squared_distance_m2 < b.squared_distance_m2
               : a.number < b.number;
  });
  all.resize(std::min(count, all.size()));
  return all;
}

TEST(FindNearest, IsWhatBruteForceFinds) {
  Rng rng(1);
  for (const std::size_t count : {1, 2, 8, 9, 10, 17, 100, 467}) {
    for (const bool on_grid : {false, true}) {
      const std::vector<Vector3> positions = SomePositions(count, rng, on_grid);
      const OwnedTree tree(positions);
      for (const std::size_t k : {1, 3, 12}) {
        for (int i = 0; i < 20; ++i) {
          const Vector3 point = SomePositions(1, rng, on_grid)[0];
          std::vector<Neighbour> found(k);
          found.resize(FindNearest(tree.View(), point, found));
          const std::vector<Neighbour> expected = ByBruteForce(positions, point, k);
          ASSERT_EQ(found.size(), expected.size());
          for (std::size_t n = 0; n < found.size(); ++n) {
            EXPECT_EQ(found[n].number, expected[n].number);
            EXPECT_EQ(found[n].squared_distance_m2, expected[n].squared_distance_m2);
            EXPECT_EQ(tree.numbers[found[n].row], found[n].number);
          }
        }
      }
    }
  }
}

TEST(FindNearest, PrefersTheLowerNumberOfEqualPlaces) {
  const std::vector<Vector3> positions(40, Vector3{1, 2, 3});
  const OwnedTree tree(positions);
  std::array<Neighbour, 2> found;
  EXPECT_EQ(FindNearest(tree.View(), {0, 0, 0}, found), 2U);
  EXPECT_EQ(found[0].number, 0);
  EXPECT_EQ(found[1].number, 1);
}

TEST(FindNearest, OfNothingIsNothing) {
  std::array<Neighbour, 2> found;
  EXPECT_EQ(FindNearest({}, {0, 0, 0}, found), 0U);
  const OwnedTree tree({{0, 0, 0}});
  EXPECT_EQ(FindNearest(tree.View(), {0, 0, 0}, {}), 0U);
}

TEST(IsTree, HoldsForTreesAlone) {
  Rng rng(2);
  for (const std::size_t count : {0, 1, 8, 9, 33, 200}) {
    OwnedTree tree(SomePositions(count, rng, false));
    EXPECT_TRUE(IsTree(tree.rows)) << count;
    if (count <= kTreeLeafRows) continue;
    // The dividing row of the whole moved out of the middle.
    tree.rows[3 * (count / 2)] = 1e6;
    EXPECT_FALSE(IsTree(tree.rows)) << count;
  }
}

TEST(TreeOrder, HoldsEachPositionOnce) {
  Rng rng(3);
  std::vector<std::size_t> order = TreeOrder(SomePositions(50, rng, true));
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> expected(50);
  std::iota(expected.begin(), expected.end(), 0U);
  EXPECT_EQ(order, expected);
}

}  // namespace
}  // namespace handcraft::features
