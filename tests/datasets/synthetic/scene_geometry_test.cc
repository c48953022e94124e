// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/scene_geometry.h"

#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/datasets/synthetic/small_scene.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

Hit CastDown(const RayTracer& tracer, float x, float y) {
  RayPacket rays;
  rays.Add({x, y, 1.0F}, -Vector3f::UnitZ(), 10.0F);
  return tracer.Intersect(rays)[0];
}

TEST(SceneGeometry, KnowsWhatWasHitAndWhere) {
  Scene scene = testing::SmallScene();
  scene.objects[1].base_from_object = Eigen::Translation3f(0.3F, 0.0F, 0.0F) *
                                      Eigen::Isometry3f(Eigen::AngleAxisf(0.5F, Vector3f::UnitZ()));
  const SceneGeometry geometry(scene);
  const RayTracer tracer(geometry.meshes());
  const Hit box = CastDown(tracer, 0.31F, 0.02F);
  const Hit slab = CastDown(tracer, 0.0F, 0.0F);
  EXPECT_TRUE(geometry.IsTarget(box));
  EXPECT_TRUE(geometry.IsGraspable(box));
  EXPECT_FALSE(geometry.IsTarget(slab));
  EXPECT_FALSE(geometry.IsTarget(Hit{}));
  EXPECT_FALSE(geometry.IsGraspable(Hit{}));
  const SurfacePoint point = geometry.PointAt(box, -Vector3f::UnitZ());
  EXPECT_TRUE(point.p_in_base.isApprox(Vector3f(0.31F, 0.02F, 0.1F), 1e-4F));
  EXPECT_TRUE(point.normal.isApprox(Vector3f::UnitZ(), 1e-4F));
  EXPECT_EQ(point.material, scene.objects[1].object.materials.data());
}

TEST(SceneGeometry, TurnsNormalsTowardsTheViewerAndPatternsWithTheObject) {
  Scene scene = testing::SmallScene();
  scene.objects[1].object.materials[0].pattern = Pattern::kStripes;
  const SceneGeometry geometry(scene);
  const RayTracer tracer(geometry.meshes());
  const Hit box = CastDown(tracer, 0.01F, 0.02F);
  EXPECT_TRUE(geometry.ShapeAt(box, Vector3f::UnitZ()).normal.isApprox(-Vector3f::UnitZ(), 1e-4F));
  const Colour before = geometry.PointAt(box, -Vector3f::UnitZ()).albedo;
  scene.objects[1].base_from_object.translation() = Vector3f(0.0F, 0.0F, 0.013F);
  const SceneGeometry raised(scene);
  EXPECT_TRUE(raised.PointAt(box, -Vector3f::UnitZ()).albedo.isApprox(before, 1e-4F));
}

TEST(SceneGeometry, RefusesAHitOfNothing) {
  const Scene scene = testing::SmallScene();
  EXPECT_THROW(static_cast<void>(SceneGeometry(scene).PointAt(Hit{}, Vector3f::UnitZ())),
               std::logic_error);
}

TEST(SceneGeometry, ShrinksClearFacesToPointsForWhatCastsShadows) {
  Scene scene = testing::SmallScene();
  EXPECT_FALSE(SceneGeometry(scene).HasClearMaterial());
  std::vector<Material>& materials = scene.objects[1].object.materials;
  materials.push_back(Clear(Colour::Ones()));
  for (Face& face : scene.objects[1].object.mesh.faces) {
    if (face.surface.graspable) face.surface.material = 1;
  }
  const SceneGeometry geometry(scene);
  EXPECT_TRUE(geometry.HasClearMaterial());
  const std::vector<Mesh> opaque = geometry.OpaqueMeshes();
  ASSERT_EQ(opaque.size(), 2U);
  EXPECT_EQ(SurfaceAreas(opaque[0]).all, SurfaceAreas(geometry.meshes()[0]).all);
  EXPECT_EQ(SurfaceAreas(opaque[1]).graspable, 0.0) << "the clear half";
  const Areas whole = SurfaceAreas(geometry.meshes()[1]);
  EXPECT_NEAR(SurfaceAreas(opaque[1]).all, whole.all - whole.graspable, 1e-6);
  EXPECT_EQ(opaque[1].faces.size(), geometry.meshes()[1].faces.size()) << "numbers are kept";
}

}  // namespace
}  // namespace handcraft::synthetic
