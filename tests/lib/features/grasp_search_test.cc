// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/grasp_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::features {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// A class of one view an angle, poses at some of the angles; owns its numbers.
struct Shown {
  std::vector<double> normals = {};
  std::vector<double> moments = {};
  HalvesMoments scales = {};
  std::vector<double> view_angles = {};
  std::vector<double> shown_angles = {};
  std::vector<std::int32_t> begins = {0};
  std::vector<double> positions = {};
  std::vector<double> rotations = {};
  std::vector<std::int32_t> numbers = {};

  void AddAngle(double angle_rad, const std::vector<Vector3>& p, const std::vector<Quaternion>& q) {
    shown_angles.push_back(angle_rad);
    const std::int32_t first = begins.back();
    for (const std::size_t i : TreeOrder(p)) {
      positions.insert(positions.end(), p[i].begin(), p[i].end());
      rotations.insert(rotations.end(), q[i].begin(), q[i].end());
      numbers.push_back(first + static_cast<std::int32_t>(i));
    }
    begins.push_back(static_cast<std::int32_t>(numbers.size()));
  }
  [[nodiscard]] ShownClass View() const {
    return {.views = {normals, moments, scales},
            .view_angles_rad = view_angles,
            .shown_angles_rad = shown_angles,
            .begins = begins,
            .positions_m = positions,
            .rotations = rotations,
            .numbers = numbers};
  }
};

// Poses at 0° and at 90°.
Shown TwoAngles() {
  Shown shown;
  shown.AddAngle(0.0, {{0.1, 0.0, 0.0}, {0.0, 0.2, 0.05}}, {TurnAboutZ(0.0), TurnAboutZ(1.0)});
  shown.AddAngle(90.0 * kDegree, {{0.0, 0.1, 0.0}}, {TurnAboutZ(2.0)});
  return shown;
}

// The object was shown unturned; the hand was 0.1 m before p_m. Standing elsewhere, turned by 20°.
TEST(FindGraspAt, OfAHandCase) {
  const Shown shown = TwoAngles();
  const double turn_rad = 20.0 * kDegree;
  const Vector3 mean_m = {3.0, -1.0, 0.5};
  const Vector3 point_m = {
      mean_m[0] + 0.1 * std::cos(turn_rad), mean_m[1] + 0.1 * std::sin(turn_rad), mean_m[2] + 0.01};
  const FoundGrasp found =
      FindGraspAt(shown.View(), turn_rad, mean_m, {.point_m = point_m, .num_neighbours = 1});
  EXPECT_NEAR(found.turn_rad, -turn_rad, 1e-15);
  EXPECT_EQ(found.number, 0);
  EXPECT_NEAR(found.distance_m, 0.01, 1e-12);
  const Quaternion expected = TurnAboutZ(turn_rad);  // R_E is the identity
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found.rotation[i], expected[i], 1e-15);
  EXPECT_NEAR(found.position_m[0], point_m[0], 1e-12);
  EXPECT_NEAR(found.position_m[1], point_m[1], 1e-12);
  EXPECT_NEAR(found.position_m[2], mean_m[2], 1e-12);
}

TEST(FindGraspAt, TurnsTheShorterWay) {
  const Shown shown = TwoAngles();
  const auto turn_from = [&shown](double angle_deg) {
    return FindGraspAt(shown.View(), angle_deg * kDegree, {}, {}).turn_rad / kDegree;
  };
  EXPECT_NEAR(turn_from(350.0), 10.0, 1e-12);
  EXPECT_NEAR(turn_from(44.0), -44.0, 1e-12);
  EXPECT_NEAR(turn_from(46.0), 44.0, 1e-12);
  EXPECT_NEAR(turn_from(100.0), -10.0, 1e-12);
  EXPECT_NEAR(turn_from(226.0), 134.0, 1e-12);
  EXPECT_NEAR(turn_from(224.0), -134.0, 1e-12);
}

// Turning and moving object and grasp point together turns and moves the answer with them.
TEST(FindGraspAt, MovesWithTheObject) {
  Rng rng(1);
  Shown shown;
  std::vector<Vector3> positions;
  std::vector<Quaternion> rotations;
  for (int i = 0; i < 60; ++i) {
    positions.push_back({0.1 * rng.Normal(), 0.1 * rng.Normal(), 0.1 * rng.Normal()});
    rotations.push_back(Product(TurnAboutZ(6.0 * rng.Uniform()), {0.6, 0.0, 0.0, 0.8}));
  }
  shown.AddAngle(0.0, positions, rotations);
  for (const std::size_t k : {1, 5}) {
    const Vector3 point = {0.05, -0.02, 0.03};
    const FoundGrasp here =
        FindGraspAt(shown.View(), 0.0, {}, {.point_m = point, .num_neighbours = k});
    const double turn_rad = 2.0;
    const Vector3 mean_m = {0.4, 0.3, 0.1};
    Vector3 moved = TurnedAboutZ(point, turn_rad);
    Vector3 position_m = TurnedAboutZ(here.position_m, turn_rad);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      moved[axis] += mean_m[axis];
      position_m[axis] += mean_m[axis];
    }
    const FoundGrasp there =
        FindGraspAt(shown.View(), turn_rad, mean_m, {.point_m = moved, .num_neighbours = k});
    EXPECT_EQ(there.number, here.number);
    const Quaternion rotation = Product(TurnAboutZ(turn_rad), here.rotation);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(there.rotation[i], rotation[i], 1e-12);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(there.position_m[i], position_m[i], 1e-12);
  }
}

TEST(FindGraspAt, ManyNeighboursAreAveragedByDistance) {
  Shown shown;
  shown.AddAngle(0.0,
                 {{0.001, 0, 0}, {-0.001, 0, 0}, {1, 0, 0}},
                 {TurnAboutZ(0.2), TurnAboutZ(0.4), TurnAboutZ(3)});
  const FoundGrasp two = FindGraspAt(shown.View(), 0.0, {}, {.point_m = {}, .num_neighbours = 2});
  const Quaternion middle = TurnAboutZ(0.3);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(two.rotation[i], middle[i], 1e-12);
  EXPECT_NEAR(two.position_m[0], 0.0, 1e-15);
  // Of more neighbours than there are poses, all count.
  const FoundGrasp all = FindGraspAt(shown.View(), 0.0, {}, {.point_m = {}, .num_neighbours = 32});
  EXPECT_NEAR(all.position_m[0], (1.0 / 1.001) / (2.0 / 0.002 + 1.0 / 1.001), 1e-15);
}

TEST(RankGraspsAt, PassesOverNearerOnes) {
  Shown shown;
  shown.AddAngle(0.0,
                 {{0.3, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}},
                 {TurnAboutZ(0.3), TurnAboutZ(0.1), TurnAboutZ(0.2)});
  std::vector<FoundGrasp> grasps(5);
  ASSERT_EQ(RankGraspsAt(shown.View(), 0.0, {}, {}, grasps), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const double part = 0.1 * static_cast<double>(i + 1);
    EXPECT_NEAR(grasps[i].distance_m, part, 1e-15);
    EXPECT_NEAR(grasps[i].position_m[0], part, 1e-15);
    EXPECT_NEAR(grasps[i].rotation[2], TurnAboutZ(part)[2], 1e-15);
  }
  EXPECT_EQ(grasps[0].number, 1);
  EXPECT_EQ(grasps[1].number, 2);
  EXPECT_EQ(grasps[2].number, 0);
  // Of two neighbours the last has but one left.
  ASSERT_EQ(RankGraspsAt(shown.View(), 0.0, {}, {.num_neighbours = 2}, grasps), 3U);
  EXPECT_NEAR(
      grasps[1].position_m[0], (0.2 / 0.201 + 0.3 / 0.301) / (1 / 0.201 + 1 / 0.301), 1e-15);
  EXPECT_NEAR(grasps[2].position_m[0], 0.3, 1e-15);
}

// Against sorting all distances; more are asked for than are ranked.
TEST(RankGraspsAt, RanksAsSortingDoes) {
  Rng rng(2);
  std::vector<Vector3> positions(300);
  for (Vector3& position : positions) position = {rng.Normal(), rng.Normal(), rng.Normal()};
  Shown shown;
  shown.AddAngle(0.5, positions, std::vector(positions.size(), TurnAboutZ(0.0)));
  const Vector3 point = {0.1, -0.2, 0.3};
  std::vector<std::pair<double, std::int32_t>> expected;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vector3& p = positions[i];
    expected.emplace_back(std::hypot(p[0] - point[0], p[1] - point[1], p[2] - point[2]),
                          static_cast<std::int32_t>(i));
  }
  std::sort(expected.begin(), expected.end());
  std::vector<FoundGrasp> grasps(100);
  ASSERT_EQ(RankGraspsAt(shown.View(), 0.5, {}, {.point_m = point, .num_neighbours = 32}, grasps),
            kMaxRankedGrasps);
  for (std::size_t i = 0; i < kMaxRankedGrasps; ++i) {
    EXPECT_EQ(grasps[i].number, expected[i].second);
    EXPECT_NEAR(grasps[i].distance_m, expected[i].first, 1e-12);
  }
  const FoundGrasp first =
      FindGraspAt(shown.View(), 0.5, {}, {.point_m = point, .num_neighbours = 32});
  EXPECT_EQ(first.position_m, grasps[0].position_m);
  EXPECT_EQ(first.rotation, grasps[0].rotation);
}

TEST(FindGrasp, TakesTheAngleOfTheNearestView) {
  Shown shown = TwoAngles();
  ViewDescription view;
  for (int i = 0; i < 9; ++i) {
    const double angle_rad = 10.0 * i * kDegree;
    view.normal = {std::cos(angle_rad), std::sin(angle_rad), 0.0};
    view.moments.fill(1.0);
    shown.normals.insert(shown.normals.end(), view.normal.begin(), view.normal.end());
    shown.moments.insert(shown.moments.end(), view.moments.begin(), view.moments.end());
    shown.view_angles.push_back(angle_rad);
  }
  shown.scales = MomentScales(shown.moments);
  view.normal = {std::cos(0.37), std::sin(0.37), 0.0};  // 21.2°
  const FoundGrasp found = FindGrasp(shown.View(), {}, view, {});
  EXPECT_EQ(found.view, 2U);
  EXPECT_NEAR(found.object_angle_rad, 20.0 * kDegree, 1e-15);
  EXPECT_NEAR(found.turn_rad, -20.0 * kDegree, 1e-15);
}

}  // namespace
}  // namespace handcraft::features
