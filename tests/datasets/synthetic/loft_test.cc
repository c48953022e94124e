// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/loft.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/expect_throws_message.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using ::testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// Area of a regular polygon on a circle of radius 1: what 64 segments make of π.
double PolygonArea(int n) { return 0.5 * n * std::sin(2.0 * kPi / n); }

TEST(Revolve, HasTheVolumeOfACylinder) {
  const Mesh mesh = Revolve({{0.04F, 0.0F, {}}, {0.04F, 0.1F, {}}}, Ends::kCapped);
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), PolygonArea(64) * 0.04 * 0.04 * 0.1, 1e-9);
}

TEST(Revolve, HasTheVolumeOfATruncatedCone) {
  const Mesh mesh = Revolve({{0.04F, 0.0F, {}}, {0.02F, 0.1F, {}}}, Ends::kCapped, 200);
  const double expected = PolygonArea(200) * 0.1 / 3.0 * (0.0016 + 0.0008 + 0.0004);
  EXPECT_NEAR(Volume(mesh), expected, 1e-9);
}

TEST(Revolve, JoinsARing) {
  const Mesh mesh =
      Revolve({{0.04F, 0.0F, {}}, {0.04F, 0.02F, {}}, {0.03F, 0.02F, {}}, {0.03F, 0.0F, {}}},
              Ends::kJoined);
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), PolygonArea(64) * (0.0016 - 0.0009) * 0.02, 1e-9);
}

TEST(Revolve, RefusesAPointOnTheAxis) {
  EXPECT_THROWS_MESSAGE(Revolve({{0.0F, 0.0F, {}}, {1.0F, 1.0F, {}}}, Ends::kCapped),
                        std::logic_error,
                        HasSubstr("radius_m"));
}

TEST(Loft, RefusesTooFewAndUnequalRings) {
  const Section triangle{.ring = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, .surface = {}};
  Section square = triangle;
  square.ring.emplace_back(0.0F, -1.0F, 0.0F);
  EXPECT_THROW(static_cast<void>(Loft(std::vector{triangle}, Ends::kCapped)), std::logic_error);
  EXPECT_THROW(static_cast<void>(Loft(std::vector{triangle, square}, Ends::kCapped)),
               std::logic_error);
}

TEST(WalledProfile, MakesATubOfTheWallsVolume) {
  constexpr float kWall = 0.004F;
  const Profile outside =
      SmoothProfile({{0.04F, 0.0F, {}}, {0.04F, 0.05F, {}}, {0.04F, 0.1F, {}}}, 10);
  const Mesh mesh = Revolve(WalledProfile(outside, kWall), Ends::kCapped, 200);
  EXPECT_TRUE(IsClosed(mesh));
  const double wall = kPi * (0.0016 - 0.036 * 0.036) * 0.1;
  const double floor = kPi * 0.036 * 0.036 * 0.004;
  EXPECT_NEAR(Volume(mesh), wall + floor, 0.05 * (wall + floor)) << "round rim, chamfered floor";
  EXPECT_NEAR(Bounds(mesh).max().z(), 0.102F, 1e-4F) << "the rim is a half circle of the wall";
}

TEST(SmoothProfile, PassesThroughThePointsAndKeepsStraightLines) {
  const Profile smooth =
      SmoothProfile({{1.0F, 0.0F, {3, false}}, {1.0F, 1.0F, {}}, {1.0F, 2.0F, {}}}, 4);
  ASSERT_EQ(smooth.size(), 9U);
  EXPECT_FLOAT_EQ(smooth[4].height_m, 1.0F);
  for (const ProfilePoint& point : smooth) EXPECT_FLOAT_EQ(point.radius_m, 1.0F);
  EXPECT_EQ(smooth[3].surface.material, 3);
  EXPECT_EQ(smooth[4].surface.material, 0);
}

TEST(MarkBetween, MarksWholeStripsByTheirMiddle) {
  Profile profile;
  for (int i = 0; i <= 10; ++i) profile.push_back({1.0F, 0.1F * static_cast<float>(i), {}});
  MarkBetween(profile, 0.29F, 0.61F);
  for (std::size_t i = 0; i < 10; ++i)
    EXPECT_EQ(profile[i].surface.graspable, i >= 3 && i < 6) << i;
}

TEST(RoundedBox, HasTheVolumeOfItsSections) {
  const Mesh mesh = RoundedBox({0.10F, 0.06F, 0.03F}, 0.005F, {});
  EXPECT_TRUE(IsClosed(mesh));
  // The section at inset s is a rectangle less the corners; radius 6 mm at the corners.
  double expected = 0.0;
  constexpr int kSlices = 20000;
  for (int i = 0; i < kSlices; ++i) {
    const double z = 0.03 * (i + 0.5) / kSlices;
    const double into_edge = std::max({0.005 - z, z - 0.025, 0.0});
    const double inset = 0.005 - std::sqrt(0.005 * 0.005 - into_edge * into_edge);
    const double corner = 0.006 - inset;
    expected +=
        ((0.10 - 2 * inset) * (0.06 - 2 * inset) - (4 - kPi) * corner * corner) * 0.03 / kSlices;
  }
  EXPECT_NEAR(Volume(mesh), expected, 0.005 * expected) << "24 chords a corner, 4 a rounded edge";
  EXPECT_TRUE(Bounds(mesh).sizes().isApprox(Vector3f(0.10F, 0.06F, 0.03F), 1e-4F));
}

TEST(Extrude, HasTheVolumeOfAHexagonalPrism) {
  const std::vector<Station> stations = {{0.0F, 0.0F, {}}, {0.1F, 0.0F, {}}};
  const Mesh mesh = Extrude(RegularPolygon(0.004F, 6), stations);
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), PolygonArea(6) * 0.004 * 0.004 * 0.1, 1e-11);
}

TEST(Ellipse, HasNormalsAcrossItsTangents) {
  const Outline outline = Ellipse({0.03F, 0.02F}, 360);
  for (std::size_t i = 0; i < 360; ++i) {
    const Vector2f chord = outline.points[(i + 1) % 360] - outline.points[(i + 359) % 360];
    EXPECT_NEAR(chord.normalized().dot(outline.normals[i]), 0.0F, 1e-3F);
  }
}

TEST(Sweep, HasTheVolumeOfATorus) {
  // Half of one, so that it has two ends: π r² · π R.
  std::vector<PathPoint> path;
  for (int i = 0; i <= 200; ++i) {
    const float angle_rad = static_cast<float>(kPi * i / 200.0);
    path.push_back({0.03F * Vector3f(std::sin(angle_rad), 0.0F, -std::cos(angle_rad)),
                    Vector2f::Constant(0.005F),
                    {0, true}});
  }
  const Mesh mesh = Sweep(path, Vector3f::UnitY(), 64);
  EXPECT_TRUE(IsClosed(mesh));
  EXPECT_NEAR(Volume(mesh), PolygonArea(64) * 25e-6 * kPi * 0.03, 0.002 * kPi * kPi * 25e-6 * 0.03);
  EXPECT_DOUBLE_EQ(SurfaceAreas(mesh).all, SurfaceAreas(mesh).graspable);
}

TEST(CatmullRom, PassesThroughTheMiddleTwoAndKeepsLinesStraight) {
  const std::array<float, 4> values = {1.0F, 2.0F, 5.0F, 3.0F};
  EXPECT_FLOAT_EQ(CatmullRom(values, 0.0F), 2.0F);
  EXPECT_FLOAT_EQ(CatmullRom(values, 1.0F), 5.0F);
  EXPECT_FLOAT_EQ(CatmullRom({0.0F, 1.0F, 2.0F, 3.0F}, 0.25F), 1.25F);
  // By hand at t = 1/2: (−p0 + 9 p1 + 9 p2 − p3) / 16.
  EXPECT_FLOAT_EQ(CatmullRom(values, 0.5F), 59.0F / 16.0F);
}

}  // namespace
}  // namespace handcraft::synthetic
