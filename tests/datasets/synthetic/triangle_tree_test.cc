// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/triangle_tree.h"

#include <gtest/gtest.h>

#include "datasets/synthetic/draw.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

OrientedBox CubeAt(const Vector3f& at, float half_size_m) {
  return {Eigen::Isometry3f(Eigen::Translation3f(at)), Vector3f::Constant(half_size_m)};
}

TEST(TriangleTree, FindsASurfaceWhereItIs) {
  const TriangleTree tree(testing::Can(0.05F, 0.2F));
  EXPECT_TRUE(tree.Touches(CubeAt({0.05F, 0.0F, 0.1F}, 0.01F)));
  EXPECT_TRUE(tree.Touches(CubeAt({0.0F, 0.0F, 0.2F}, 0.01F)));
  EXPECT_FALSE(tree.Touches(CubeAt({0.07F, 0.0F, 0.1F}, 0.01F)));
  EXPECT_FALSE(tree.Touches(CubeAt({0.0F, 0.0F, 0.1F}, 0.01F))) << "within, off the surface";
  EXPECT_TRUE(tree.Touches(CubeAt({0.0F, 0.0F, 0.1F}, 1.0F))) << "all around it";
}

TEST(TriangleTree, OfNothingTouchesNothing) {
  EXPECT_FALSE(TriangleTree(Mesh{}).Touches(CubeAt(Vector3f::Zero(), 1.0F)));
}

TEST(TriangleTree, AgreesWithLookingAtEveryTriangle) {
  const Mesh mesh = testing::Ball(0.08F, 0.1F);
  const TriangleTree tree(mesh);
  Rng rng = Rng::Stream(1, "tree");
  const auto draw = [&](float reach) {
    const float x = Between(rng, -reach, reach);
    const float y = Between(rng, -reach, reach);
    return Vector3f(x, y, Between(rng, -reach, reach));
  };
  int num_touching = 0;
  constexpr int kNumBoxes = 400;
  for (int i = 0; i < kNumBoxes; ++i) {
    OrientedBox box;
    const Vector3f axis = draw(1.0F).normalized();
    box.frame_from_box = Eigen::Translation3f(draw(0.12F) + Vector3f(0.0F, 0.0F, 0.1F)) *
                         Eigen::AngleAxisf(Between(rng, 0.0F, 3.0F), axis);
    box.half_size_m = draw(0.03F).cwiseAbs();
    const bool expected = testing::TouchesAny(mesh, box, 1e-6);
    if (expected != testing::TouchesAny(mesh, box, -1e-6)) continue;
    num_touching += expected ? 1 : 0;
    EXPECT_EQ(tree.Touches(box), expected) << i;
  }
  EXPECT_GT(num_touching, kNumBoxes / 10);
  EXPECT_LT(num_touching, kNumBoxes * 9 / 10);
}

TEST(TriangleTree, TakesTrianglesThatLieOnEachOther) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.faces.resize(1000, {.vertices = {0, 1, 2}, .surface = {}});
  const TriangleTree tree(mesh);
  EXPECT_TRUE(tree.Touches(CubeAt({0.2F, 0.2F, 0.0F}, 0.1F)));
  EXPECT_FALSE(tree.Touches(CubeAt({0.8F, 0.8F, 0.0F}, 0.1F)));
}

}  // namespace
}  // namespace handcraft::synthetic
