// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/view_sets.h"

#include <set>
#include <string>

#include "datasets/view_set_faults.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/synthetic/small_camera.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/read_tree.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using datasets::ObjectView;
using handcraft::testing::ReadTree;
using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::SmallCamera;
using ::testing::StartsWith;

// Four classes seen once each by a small camera without fault: fast.
ViewSetOptions FastOptions() {
  return {.family = Family::kRegrasp,
          .num_views = 1,
          .sensor = CloudSensor::kPerfect,
          .camera = SmallCamera()};
}

TEST(MakeViewSet, MakesASoundTurntable) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  options.num_views = 2;
  options.num_threads = 2;
  const datasets::ViewSet made = MakeViewSet(folder / "set", options).set;
  const datasets::ViewSet set = datasets::ReadViewSet(folder / "set");
  ASSERT_EQ(set.items.size(), 8U);
  EXPECT_THAT(datasets::FindFaults(set), IsEmpty());
  EXPECT_EQ(datasets::Fingerprint(set), datasets::Fingerprint(made));
  std::set<std::string> instances;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const ObjectView& view = set.items[i];
    instances.insert(view.instance);
    EXPECT_EQ(view.angle_deg, 180.0 * static_cast<double>(i % 2));
    EXPECT_EQ(view.split, "test") << "not the family that is taught";
    EXPECT_TRUE(fs::exists(set.root / view.depth));
  }
  EXPECT_EQ(instances.size(), 4U);
  EXPECT_EQ(set.items[0].symmetry, "round") << "a water bottle";
  EXPECT_EQ(set.items[2].symmetry, "none") << "a spray bottle";
}

// Where a point of the mesh is seen, the cloud has it: place, turn and frame agree.
TEST(MakeViewSet, PutsTheObjectWhereItsPoseSays) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  options.num_views = 2;
  const datasets::ViewSet set = MakeViewSet(folder / "set", options).set;
  for (std::size_t i = 2; i < 4; ++i) {
    const datasets::LoadedView view = datasets::ReadView(set, i);
    const Mesh mesh = DrawInstance(ClassesOf(Family::kRegrasp)[1], 1, 0).mesh;
    const Eigen::AlignedBox3f bounds = Bounds(mesh);
    const Eigen::Isometry3f object_from_base = TurntablePose(*set.items[i].angle_deg).inverse();
    int num_object = 0;
    for (std::size_t pixel = 0; pixel < view.cloud->points.size(); ++pixel) {
      if (view.object_mask.values()[pixel] == 0) continue;
      ++num_object;
      EXPECT_LT(bounds.exteriorDistance(object_from_base * view.cloud->points[pixel]), 1e-3F);
    }
    EXPECT_GT(num_object, 200);
  }
}

TEST(MakeViewSet, MovesTheSameObjects) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  options.kind = ViewSetKind::kMoved;
  const datasets::ViewSet set = MakeViewSet(folder / "set", options).set;
  EXPECT_THAT(datasets::FindFaults(set), IsEmpty());
  EXPECT_NE(set.items[0].angle_deg, set.items[1].angle_deg);
  EXPECT_EQ(set.items[0].split, "test");
  EXPECT_EQ(set.items[0].instance, "water_bottle_0000");
  EXPECT_THAT(ReadTextFile(folder / "set/scenes/water_bottle_0000_00.toml"),
              StartsWith("angle_deg = "));
}

TEST(MakeViewSet, CallsTheTurntableOfTheTaughtFamilyTraining) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  options.family = Family::kTaught;
  EXPECT_EQ(MakeViewSet(folder / "set", options).set.items[0].split, "train");
}

TEST(MakeViewSet, GivesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  options.sensor = CloudSensor::kStereo;
  options.camera_noise = {.position_m = 0.003F, .angle_deg = 0.3F};
  MakeViewSet(folder / "one", options);
  options.num_threads = 2;
  MakeViewSet(folder / "two", options);
  EXPECT_TRUE(ReadTree(folder / "one") == ReadTree(folder / "two"));
}

TEST(MakeViewSet, GoesOnWhereItWasStopped) {
  const TemporaryDirectory folder;
  const ViewSetOptions options = FastOptions();
  MakeViewSet(folder / "whole", options);
  fs::copy(folder / "whole", folder / "stopped", fs::copy_options::recursive);
  fs::remove(folder / "stopped/views.csv");
  fs::remove(folder / "stopped/scenes/drill_0000_00.toml");
  fs::remove(folder / "stopped/clouds/drill_0000_00.pcd");
  WriteFileAtomically(folder / "stopped/clouds/drill_0000_00.pcd.aB3xYz", "half");
  const auto kept = fs::last_write_time(folder / "stopped/clouds/coffee_can_0000_00.pcd");
  MakeViewSet(folder / "stopped", options);
  EXPECT_TRUE(ReadTree(folder / "stopped") == ReadTree(folder / "whole"));
  EXPECT_EQ(fs::last_write_time(folder / "stopped/clouds/coffee_can_0000_00.pcd"), kept);
}

TEST(MakeViewSet, MakesAViewAgainOfWhichAnyFileIsNotWhole) {
  const TemporaryDirectory folder;
  const ViewSetOptions options = FastOptions();
  MakeViewSet(folder / "set", options);
  const auto whole = ReadTree(folder / "set");
  EXPECT_TRUE(MakeViewSet(folder / "set", options).written.IsNothing());
  fs::remove(folder / "set/object_masks/drill_0000_00.png");
  fs::resize_file(folder / "set/clouds/coffee_can_0000_00.pcd", 1000);
  WriteFileAtomically(folder / "set/views.csv", "");
  const Written written = MakeViewSet(folder / "set", options).written;
  EXPECT_EQ(written.num_pictures, 2U);
  EXPECT_EQ(written.num_lists, 1U);
  EXPECT_TRUE(ReadTree(folder / "set") == whole);
}

TEST(MakeViewSet, RefusesToGoOnWithOtherOptions) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  MakeViewSet(folder / "set", options);
  const auto refuses = [&] {
    EXPECT_THROWS_MESSAGE(MakeViewSet(folder / "set", options),
                          Error,
                          HasSubstr("tells of a set made with other options"));
  };
  options.sensor = CloudSensor::kDepthCamera;
  refuses();
  options = FastOptions();
  options.kind = ViewSetKind::kMoved;
  refuses();
  options = FastOptions();
  options.camera_noise.angle_deg = 0.5F;
  refuses();
}

TEST(MakeViewSet, TellsWhenTheCameraSeesNoWholeObject) {
  const TemporaryDirectory folder;
  ViewSetOptions options = FastOptions();
  options.camera.focal_px = 600.0F;
  EXPECT_THROWS_MESSAGE(MakeViewSet(folder / "set", options),
                        Error,
                        HasSubstr("the camera does not see the water_bottle whole"));
}

TEST(DrawInstance, IsTheSameObjectInEverySetOfASeed) {
  const ObjectClass& kind = ClassesOf(Family::kTaught)[3];
  EXPECT_EQ(DrawInstance(kind, 1, 0).mesh.vertices, DrawInstance(kind, 1, 0).mesh.vertices);
  EXPECT_NE(DrawInstance(kind, 1, 0).mesh.vertices, DrawInstance(kind, 1, 1).mesh.vertices);
  EXPECT_NE(DrawInstance(kind, 1, 0).mesh.vertices, DrawInstance(kind, 2, 0).mesh.vertices);
}

TEST(ViewSetOptions, RefusesWhatCannotBe) {
  const auto refuses = [](const ViewSetOptions& options, const std::string& message) {
    EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr(message));
  };
  EXPECT_NO_THROW(ViewSetOptions().Validate());
  refuses({.family = Family::kTrained}, "ViewSetOptions.family is trained; it must be taught, unt");
  refuses({.num_views = 0}, "ViewSetOptions.num_views is 0; it must be from 1 to 10000");
  refuses({.camera_noise = {.position_m = -1.0F}}, "CameraNoise.position_m is -1");
  refuses({.camera_noise = {.angle_deg = 9.0F}},
          "CameraNoise.angle_deg is 9; it must be from 0 to");
  refuses({.camera = {.focal_px = 0.0F}}, "PinholeCamera.focal_px is 0");
  refuses({.baseline_m = 2.0F}, "ViewSetOptions.baseline_m is 2; it must be in (0, 1]");
  refuses({.num_threads = 0}, "ViewSetOptions.num_threads is 0");
}

}  // namespace
}  // namespace handcraft::synthetic
