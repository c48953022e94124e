// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/true_objects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/formats/scene_file.h"
#include "datasets/synthetic/demonstrations.h"
#include "datasets/synthetic/demonstrator.h"
#include "datasets/synthetic/grasp_trial.h"
#include "datasets/synthetic/view_sets.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/synthetic/small_camera.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

ViewSetOptions SmallViews(ViewSetKind kind) {
  return {.kind = kind,
          .family = Family::kRegrasp,
          .num_views = 2,
          .sensor = CloudSensor::kPerfect,
          .camera = testing::SmallCamera(),
          .seed = 7};
}

void ReplaceIn(const std::filesystem::path& path, const std::string& from, const std::string& to) {
  std::string text = ReadTextFile(path);
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  WriteFileAtomically(path, text.replace(at, from.size(), to));
}

// Law: the surface of what is drawn again is where the view's perfect cloud was measured.
TEST(DrawTrueObject, IsWhatTheViewShows) {
  const TemporaryDirectory folder;
  for (const ViewSetKind kind : {ViewSetKind::kTurntable, ViewSetKind::kMoved}) {
    const auto root = folder / std::string(NameOf(kind));
    const datasets::ViewSet set = MakeViewSet(root, SmallViews(kind)).set;
    for (std::size_t i = 0; i < set.items.size(); ++i) {
      const TrueObject object = DrawTrueObject(set, i);
      Mesh placed = object.mesh;
      Transform(placed, object.base_from_object);
      const TriangleTree surface(placed);
      const datasets::LoadedView view = datasets::ReadView(set, i);
      int num_points = 0;
      int num_off = 0;
      for (int v = 0; v < view.object_mask.height(); ++v) {
        for (int u = 0; u < view.object_mask.width(); ++u) {
          if (view.object_mask.At(u, v) == 0) continue;
          const Eigen::Vector3f p = view.cloud->At(u, v);
          if (!p.allFinite()) continue;
          OrientedBox around{.half_size_m = Eigen::Vector3f::Constant(0.002F)};
          around.frame_from_box.translation() = p;
          ++num_points;
          num_off += surface.Touches(around) ? 0 : 1;
        }
      }
      EXPECT_GT(num_points, 50) << set.items[i].image;
      EXPECT_EQ(num_off, 0) << set.items[i].image;
    }
  }
}

// Law: a pose that was shown holds its own object where it stands.
TEST(DrawTrueObject, IsHeldByEveryDemonstrationShownForIt) {
  const TemporaryDirectory folder;
  const MadeDemonstrations made = MakeDemonstrations(
      folder / "shown", {.views = SmallViews(ViewSetKind::kTurntable), .poses_per_view = 20});
  const datasets::ViewSet views = datasets::ReadViewSet(folder / "shown");
  std::size_t num_tried = 0;
  for (std::size_t i = 0; i < views.items.size(); ++i) {
    const TrueObject object = DrawTrueObject(views, i);
    const GraspCheck check(object.mesh, {}, TrialRules());
    for (const datasets::Demonstration& shown : made.set.items) {
      if (shown.view != views.items[i].image) continue;
      ++num_tried;
      const GraspOutcome outcome = TryGrasp(check, InObject(shown.pose, object.base_from_object));
      EXPECT_EQ(outcome.fault, GraspFault::kNone) << NameOf(outcome.fault) << " " << shown.view;
    }
  }
  EXPECT_EQ(num_tried, 160U);
}

TEST(DrawTrueObject, KeepsTheScaleOfTheMovedAndOldScenesHaveNone) {
  const TemporaryDirectory folder;
  const datasets::ViewSet set = MakeViewSet(folder / "set", SmallViews(ViewSetKind::kMoved)).set;
  const datasets::SceneRecord scene = datasets::ReadSceneFile(set.root / set.items[0].scene);
  EXPECT_NE(scene.scale, 1.0);
  const float scaled_m = Bounds(DrawTrueObject(set, 0).mesh).max().z();
  ReplaceIn(set.root / set.items[0].scene, "scale = ", "x_scale = ");
  EXPECT_NEAR(scaled_m, scene.scale * Bounds(DrawTrueObject(set, 0).mesh).max().z(), 1e-6);
}

TEST(DrawTrueObject, SaysWhyThereIsNone) {
  const TemporaryDirectory folder;
  datasets::ViewSet set = MakeViewSet(folder / "set", SmallViews(ViewSetKind::kTurntable)).set;
  const auto draw = [&] { return DrawTrueObject(set, 0); };
  ReplaceIn(folder / "set/dataset.toml", "generator = ", "generator = 90");
  EXPECT_THROWS_MESSAGE(static_cast<void>(draw()), Error, HasSubstr("version 901 of the gen"));
  ReplaceIn(folder / "set/dataset.toml", "generator = 90", "generator = ");
  ReplaceIn(folder / "set/dataset.toml", "kind = \"turntable\"", "kind = \"grasp-points\"");
  EXPECT_THROWS_MESSAGE(static_cast<void>(draw()), Error, HasSubstr("kind is \"grasp-points\""));
  ReplaceIn(folder / "set/dataset.toml", "kind = \"grasp-points\"", "kind = \"moved\"");
  ReplaceIn(set.root / set.items[0].scene, "class = \"", "class = \"other_");
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(draw()), Error, HasSubstr("is none of the family regrasp"));
  std::filesystem::remove(folder / "set/dataset.toml");
  EXPECT_THROWS_MESSAGE(static_cast<void>(draw()), Error, HasSubstr("dataset.toml"));
  set.items[0].scene.clear();
  EXPECT_THROWS_MESSAGE(static_cast<void>(draw()), Error, HasSubstr("the view has no scene"));
}

}  // namespace
}  // namespace handcraft::synthetic
