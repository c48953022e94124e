// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/oriented_box.h"

#include <gtest/gtest.h>

#include "datasets/synthetic/draw.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

Vector3f DrawPoint(Rng& rng, float reach) {
  const float x = Between(rng, -reach, reach);
  const float y = Between(rng, -reach, reach);
  return {x, y, Between(rng, -reach, reach)};
}

OrientedBox DrawBox(Rng& rng) {
  OrientedBox box;
  const Vector3f axis = DrawPoint(rng, 1.0F).normalized();
  box.frame_from_box = Eigen::Translation3f(DrawPoint(rng, 0.5F)) *
                       Eigen::AngleAxisf(Between(rng, 0.0F, 3.0F), axis);
  box.half_size_m = DrawPoint(rng, 0.4F).cwiseAbs() + Vector3f::Constant(0.01F);
  return box;
}

OrientedBox UnitBoxAt(const Vector3f& at) {
  return {Isometry3f(Eigen::Translation3f(at)), Vector3f::Constant(0.5F)};
}

// The surface of a box, two triangles a side.
std::vector<Triangle> SurfaceOf(const OrientedBox& box) {
  std::vector<Triangle> surface;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const float sign = side % 2 == 0 ? 1.0F : -1.0F;
    const auto corner = [&](float a, float b) {
      Vector3f p;
      p[axis] = sign;
      p[(axis + 1) % 3] = a;
      p[(axis + 2) % 3] = b;
      return Vector3f(box.frame_from_box * p.cwiseProduct(box.half_size_m));
    };
    surface.push_back({corner(-1, -1), corner(1, -1), corner(1, 1)});
    surface.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1)});
  }
  return surface;
}

testing::Corners ToCorners(const Triangle& triangle) {
  return {triangle[0].cast<double>(), triangle[1].cast<double>(), triangle[2].cast<double>()};
}

TEST(MovedBox, KeepsItsCorners) {
  const Isometry3f turn = Eigen::Translation3f(1.0F, 0.0F, 0.0F) *
                          Isometry3f(Eigen::AngleAxisf(0.5F, Vector3f::UnitZ()));
  const OrientedBox box = MovedBox({Vector3f(0.0F, 0.0F, 0.0F), Vector3f(2.0F, 4.0F, 6.0F)}, turn);
  EXPECT_EQ(box.half_size_m, Vector3f(1.0F, 2.0F, 3.0F));
  EXPECT_TRUE((box.frame_from_box * Vector3f(-1.0F, -2.0F, -3.0F)).isApprox(turn.translation()));
}

TEST(Around, IsTheSmallestUprightBox) {
  OrientedBox box{
      Isometry3f(Eigen::AngleAxisf(std::numbers::pi_v<float> / 4.0F, Vector3f::UnitZ())),
      {1.0F, 1.0F, 0.5F}};
  EXPECT_NEAR(Around(box).max().x(), std::sqrt(2.0F), 1e-6F);
  EXPECT_NEAR(Around(box).min().z(), -0.5F, 1e-6F);
}

TEST(OverlapOfBoxes, KnowsHandCases) {
  EXPECT_TRUE(Overlap(UnitBoxAt({0, 0, 0}), UnitBoxAt({0.9F, 0.9F, 0.9F})));
  EXPECT_TRUE(Overlap(UnitBoxAt({0, 0, 0}), UnitBoxAt({1, 0, 0}))) << "they touch";
  EXPECT_FALSE(Overlap(UnitBoxAt({0, 0, 0}), UnitBoxAt({1.001F, 0, 0})));
  // Turned by an eighth about z, a box reaches √½ along x.
  OrientedBox turned = UnitBoxAt({1.2F, 0, 0});
  turned.frame_from_box.rotate(
      Eigen::AngleAxisf(std::numbers::pi_v<float> / 4.0F, Vector3f::UnitZ()));
  EXPECT_TRUE(Overlap(UnitBoxAt({0, 0, 0}), turned));
  turned.frame_from_box.translation().x() = 1.21F;
  EXPECT_FALSE(Overlap(UnitBoxAt({0, 0, 0}), turned));
}

TEST(OverlapOfBoxAndTriangle, KnowsHandCases) {
  const OrientedBox box = UnitBoxAt({0, 0, 0});
  EXPECT_TRUE(Overlap(box, Triangle{{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}}})) << "cuts through";
  EXPECT_TRUE(Overlap(box, Triangle{{{0, 0, 0}, {0.1F, 0, 0}, {0, 0.1F, 0}}})) << "lies within";
  EXPECT_FALSE(Overlap(box, Triangle{{{-9, -9, 0.51F}, {9, -9, 0.51F}, {0, 9, 0.51F}}}));
  // Passes the corner (0.5, 0.5, 0) outside, though every bounding box overlaps.
  EXPECT_FALSE(Overlap(box, Triangle{{{1.1F, 0, -1}, {0, 1.1F, -1}, {0.55F, 0.55F, 1}}}));
  EXPECT_TRUE(Overlap(box, Triangle{{{0.9F, 0, -1}, {0, 0.9F, -1}, {0.45F, 0.45F, 1}}}));
}

TEST(OverlapOfBoxAndTriangle, TakesTrianglesWithoutArea) {
  const OrientedBox box = UnitBoxAt({0, 0, 0});
  EXPECT_TRUE(Overlap(box, Triangle{{{0.2F, 0, 0}, {0.2F, 0, 0}, {0.2F, 0, 0}}}));
  EXPECT_FALSE(Overlap(box, Triangle{{{0.6F, 0, 0}, {0.6F, 0, 0}, {0.6F, 0, 0}}}));
  EXPECT_TRUE(Overlap(box, Triangle{{{-2, 0, 0}, {2, 0, 0}, {2, 0, 0}}}));
  EXPECT_FALSE(Overlap(box, Triangle{{{-2, 0.6F, 0}, {2, 0.6F, 0}, {1, 0.6F, 0}}}));
}

TEST(OverlapOfBoxAndTriangle, AgreesWithCutting) {
  Rng rng = Rng::Stream(1, "triangles");
  int num_overlaps = 0;
  int num_clear = 0;
  for (int i = 0; i < 4000; ++i) {
    const OrientedBox box = DrawBox(rng);
    const float size = Between(rng, 0.05F, 1.0F);
    const Vector3f at = DrawPoint(rng, 0.5F);
    const Triangle triangle = {at, at + DrawPoint(rng, size), at + DrawPoint(rng, size)};
    const bool grown = testing::CutLeavesSomething(box, ToCorners(triangle), 1e-5);
    const bool shrunk = testing::CutLeavesSomething(box, ToCorners(triangle), -1e-5);
    if (grown != shrunk) continue;  // too near to call in single precision
    ++num_clear;
    num_overlaps += grown ? 1 : 0;
    EXPECT_EQ(Overlap(box, triangle), grown) << i;
  }
  EXPECT_GT(num_clear, 3990);
  EXPECT_GT(num_overlaps, 500);
  EXPECT_LT(num_overlaps, 3500);
}

TEST(OverlapOfBoxes, AgreesWithCuttingTheirSurfaces) {
  Rng rng = Rng::Stream(2, "boxes");
  int num_overlaps = 0;
  for (int i = 0; i < 2000; ++i) {
    const OrientedBox a = DrawBox(rng);
    const OrientedBox b = DrawBox(rng);
    const auto meets = [&](double margin_m) {
      const auto touches = [&](const OrientedBox& box, const Triangle& triangle) {
        return testing::CutLeavesSomething(box, ToCorners(triangle), margin_m);
      };
      for (const Triangle& triangle : SurfaceOf(a)) {
        if (touches(b, triangle)) return true;
      }
      for (const Triangle& triangle : SurfaceOf(b)) {
        if (touches(a, triangle)) return true;
      }
      return false;
    };
    const bool grown = meets(1e-5);
    if (grown != meets(-1e-5)) continue;
    num_overlaps += grown ? 1 : 0;
    EXPECT_EQ(Overlap(a, b), grown) << i;
    EXPECT_EQ(Overlap(b, a), grown) << i;
  }
  EXPECT_GT(num_overlaps, 500);
  EXPECT_LT(num_overlaps, 1900);
}

}  // namespace
}  // namespace handcraft::synthetic
