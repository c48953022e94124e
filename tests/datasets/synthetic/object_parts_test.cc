// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/object_parts.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft::synthetic {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

std::vector<BodySection> Prism(const Vector2f& semi_axes_m, float power) {
  return {{0.0F, semi_axes_m, power, 0.0F, {}}, {0.2F, semi_axes_m, power, 0.0F, {}}};
}

// Area of a superellipse: 4 a b Γ(1 + 1/n)² / Γ(1 + 2/n).
double SuperellipseArea(const Vector2f& semi_axes_m, double power) {
  const double gamma = std::tgamma(1.0 + 1.0 / power);
  return 4.0 * static_cast<double>(semi_axes_m.prod()) * gamma * gamma /
         std::tgamma(1.0 + 2.0 / power);
}

TEST(LoftBody, HasTheVolumeOfASuperellipse) {
  const Vector2f semi_axes_m(0.03F, 0.05F);
  for (const float power : {2.0F, 2.5F, 4.0F, 6.0F}) {
    const Mesh mesh = LoftBody(Prism(semi_axes_m, power));
    const double expected = 0.2 * SuperellipseArea(semi_axes_m, static_cast<double>(power));
    EXPECT_TRUE(IsClosed(mesh));
    // Corners on the curve: the polygon of 64 lies a little within it.
    EXPECT_LT(Volume(mesh), expected * 1.0001) << power;
    EXPECT_GT(Volume(mesh), expected * 0.97) << power;
  }
}

TEST(LoftBody, ShiftsSectionsAndRefusesImpossibleOnes) {
  std::vector<BodySection> sections = Prism({0.02F, 0.02F}, 2.0F);
  for (BodySection& section : sections) section.shift_x_m = 0.1F;
  EXPECT_NEAR(Bounds(LoftBody(sections)).center().x(), 0.1F, 1e-6F);
  EXPECT_THROW((void)LoftBody(Prism({0.0F, 0.02F}, 2.0F)), std::logic_error);
  EXPECT_THROW((void)LoftBody(Prism({0.02F, 0.02F}, 1.0F)), std::logic_error);
}

TEST(SmoothSections, PassThroughTheGivenOnesAndKeepEdges) {
  const std::vector<BodySection> given = {{0.0F, {0.02F, 0.02F}, 2.0F, 0.0F, {1, false}},
                                          {0.1F, {0.03F, 0.02F}, 3.0F, 0.0F, {2, true}},
                                          {0.1F, {0.01F, 0.01F}, 2.0F, 0.0F, {3, false}},
                                          {0.2F, {0.01F, 0.01F}, 2.0F, 0.01F, {4, false}}};
  const std::vector<BodySection> smooth = SmoothSections(given, 5);
  ASSERT_EQ(smooth.size(), 5U + 1U + 5U + 1U);
  EXPECT_TRUE(smooth[5].semi_axes_m.isApprox(given[1].semi_axes_m));
  EXPECT_EQ(smooth[5].surface.material, 2);
  EXPECT_TRUE(smooth[6].semi_axes_m.isApprox(given[2].semi_axes_m));
  EXPECT_EQ(smooth[4].surface.material, 1) << "the surface of the section before";
  EXPECT_FLOAT_EQ(smooth.back().shift_x_m, 0.01F);
  for (const BodySection& section : smooth) EXPECT_GE(section.power, 2.0F);
}

TEST(SmoothPath, OfPointsOnALineStaysOnIt) {
  const std::vector<PathPoint> path = {{{0.0F, 0.0F, 0.0F}, {0.01F, 0.01F}, {}},
                                       {{0.1F, 0.0F, 0.2F}, {0.03F, 0.01F}, {1, true}},
                                       {{0.2F, 0.0F, 0.4F}, {0.03F, 0.01F}, {}}};
  const std::vector<PathPoint> smooth = SmoothPath(path, 4);
  ASSERT_EQ(smooth.size(), 9U);
  EXPECT_TRUE(smooth[4].position_m.isApprox(path[1].position_m));
  EXPECT_FLOAT_EQ(smooth[2].semi_axes_m.x(), 0.02F);
  EXPECT_TRUE(smooth[5].surface.graspable);
  for (const PathPoint& point : smooth) {
    EXPECT_NEAR(point.position_m.z(), 2.0F * point.position_m.x(), 1e-6F);
  }
  EXPECT_THROW((void)SmoothPath({path.data(), 1}, 4), std::logic_error);
}

TEST(RidgedCap, IsClosedAndAsHighAndWideAsAsked) {
  const Mesh cap = RidgedCap(0.015F, 0.02F, 24, {3, false});
  EXPECT_TRUE(IsClosed(cap));
  EXPECT_GT(Volume(cap), 0.0);
  EXPECT_NEAR(Bounds(cap).sizes().x(), 0.03F, 1e-6F);
  EXPECT_FLOAT_EQ(Bounds(cap).sizes().z(), 0.02F);
  const double cylinder = std::numbers::pi * 0.015 * 0.015 * 0.02;
  EXPECT_LT(Volume(cap), cylinder);
  EXPECT_GT(Volume(cap), 0.85 * cylinder);
}

TEST(TurnedAlongX, KeepsTheFacesOutwards) {
  const Mesh mesh = LoftBody(Prism({0.03F, 0.05F}, 2.0F));
  const Mesh turned = TurnedAlongX(mesh);
  EXPECT_NEAR(Volume(turned), Volume(mesh), 1e-9);
  EXPECT_NEAR(Bounds(turned).sizes().x(), 0.2F, 1e-6F);
  EXPECT_NEAR(Bounds(turned).sizes().y(), 0.06F, 1e-3F);
}

TEST(CentreOnTable, PutsTheMiddleOnTheAxisAndTheBottomOnTheTable) {
  Mesh mesh = MovedBy(LoftBody(Prism({0.03F, 0.05F}, 2.0F)), {0.3F, -0.2F, 0.7F});
  EXPECT_NEAR(Bounds(mesh).center().x(), 0.3F, 1e-6F);
  CentreOnTable(mesh);
  EXPECT_NEAR(Bounds(mesh).center().head<2>().norm(), 0.0F, 1e-6F);
  EXPECT_NEAR(Bounds(mesh).min().z(), 0.0F, 1e-7F);
}

TEST(Resurface, ChangesTheFacesThatItIsToldAndNoOthers) {
  Mesh mesh = LoftBody(Prism({0.03F, 0.05F}, 2.0F));
  Resurface(
      mesh, {5, true}, [](const Vector3f&, const Vector3f& normal) { return normal.z() > 0.9F; });
  for (const Face& face : mesh.faces) {
    const bool is_top = mesh.vertices[face.vertices[0]].z() > 0.19F &&
                        mesh.vertices[face.vertices[1]].z() > 0.19F &&
                        mesh.vertices[face.vertices[2]].z() > 0.19F;
    EXPECT_EQ(face.surface.material, is_top ? 5 : 0);
    EXPECT_EQ(face.surface.graspable, is_top);
  }
}

TEST(MarkHeights, MarksByTheCentroidAlone) {
  Mesh mesh = LoftBody(SmoothSections(Prism({0.03F, 0.05F}, 2.0F), 10));
  MarkHeights(mesh, 0.05F, 0.15F);
  Areas areas = SurfaceAreas(mesh);
  EXPECT_GT(areas.graspable, 0.3 * areas.all);
  EXPECT_LT(areas.graspable, 0.5 * areas.all);
  MarkHeights(mesh, 1.0F, 2.0F);
  areas = SurfaceAreas(mesh);
  EXPECT_EQ(areas.graspable, 0.0);
}

TEST(DrawLabel, PrintsInTwoColoursThatDiffer) {
  for (std::uint64_t i = 0; i < 50; ++i) {
    Rng rng = Rng::Stream(1, "labels", i);
    const Material label = DrawLabel(rng);
    EXPECT_EQ(label.pattern, Pattern::kLabel);
    EXPECT_GT((label.base - label.second).norm(), 0.2F) << i;
  }
}

TEST(DrawDarkRubber, IsDarkerThanVividPlastic) {
  Rng rng = Rng::Stream(1, "plastics");
  for (int i = 0; i < 50; ++i) {
    EXPECT_LT(DrawDarkRubber(rng).base.maxCoeff(), DrawVividPlastic(rng).base.maxCoeff());
  }
}

}  // namespace
}  // namespace handcraft::synthetic
