// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/regrasp_set.h"

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "datasets/synthetic/view_sets.h"
#include "datasets/view_set_faults.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/synthetic/brute_force_grasp.h"
#include "tests/datasets/synthetic/small_camera.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/read_tree.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;
using handcraft::testing::ReadTree;
using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::SmallCamera;

RegraspOptions SmallOptions() {
  RegraspOptions options;
  options.num_configurations = 2;
  options.poses_per_view = 2;
  options.holds_per_view = 3;
  options.sensor = CloudSensor::kPerfect;
  options.camera = SmallCamera();
  options.sampler = {.num_tries = 4000, .most_grasps = 100};
  return options;
}

// A set of two configurations an object, made once.
class SmallRegrasps : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryDirectory>();
    made_ = MakeRegraspSet(*folder_ / "set", SmallOptions());
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static inline std::unique_ptr<TemporaryDirectory> folder_;
  static inline MadeRegrasps made_;
};

TEST_F(SmallRegrasps, AreASoundSet) {
  const datasets::ViewSet views = datasets::ReadViewSet(*folder_ / "set");
  EXPECT_THAT(views.items, SizeIs(4 * 2));
  EXPECT_THAT(datasets::FindFaults(views), IsEmpty());
  const auto demonstrations = datasets::ReadDemonstrationSet(*folder_ / "set");
  EXPECT_THAT(demonstrations.items, SizeIs(4 * 2 * 2));
  EXPECT_EQ(datasets::Fingerprint(demonstrations), datasets::Fingerprint(made_.demonstrations));
  const datasets::HoldSet holds = datasets::ReadHoldSet(*folder_ / "set");
  EXPECT_THAT(holds.items, SizeIs(4 * 2 * 3));
  EXPECT_EQ(datasets::Fingerprint(holds), datasets::Fingerprint(made_.holds));
  EXPECT_EQ(made_.counts[HoldFault::kNone], holds.items.size());
  std::set<double> angles;
  for (const datasets::ObjectView& view : views.items) angles.insert(view.angle_deg.value());
  EXPECT_EQ(angles.size(), 8U) << "each view is turned in its own way";
}

TEST_F(SmallRegrasps, HoldWithBothHandsWhatStandsThere) {
  const ObjectClass& kind = ClassesOf(Family::kRegrasp)[2];
  const Object object = DrawInstance(kind, 1, 0);
  const GraspCheck check(object.mesh, {}, {});
  Rng grasp_stream = Rng::Stream(1, std::string(kind.name) + " grasps");
  GraspCounts counts;
  const std::vector<Grasp> grasps =
      SampleGrasps(check, SmallOptions().sampler, grasp_stream, counts);
  Rng place_stream = Rng::Stream(1, std::string(kind.name) + " regrasp place");
  const RegraspPlace place = DrawRegraspPlace(grasps, {}, place_stream);
  const std::string view = "images/" + std::string(kind.name) + "_0000_00.png";
  int num_holds = 0;
  for (const datasets::Hold& hold : made_.holds.items) {
    if (hold.view != view) continue;
    ++num_holds;
    for (const datasets::EndEffectorPose& pose : {hold.right, hold.left}) {
      EXPECT_GE(pose.position_m.z(), 0.05) << "Eq. 5.1";
      EXPECT_EQ(
          testing::SlowClose(object.mesh, {}, {}, InObject(pose, place.base_from_object), 2e-5),
          GraspFault::kNone);
    }
    EXPECT_EQ(RightArm().Check(hold.right.ToIsometry().cast<float>(), {}), GraspFault::kNone);
    EXPECT_EQ(LeftArm().Check(hold.left.ToIsometry().cast<float>(), {}), GraspFault::kOutOfReach);
  }
  EXPECT_EQ(num_holds, 3);
}

TEST_F(SmallRegrasps, AreTheSameBytesForAnyNumberOfThreadsAndAfterAStop) {
  const auto whole = ReadTree(*folder_ / "set");
  RegraspOptions options = SmallOptions();
  options.num_threads = 2;
  static_cast<void>(MakeRegraspSet(*folder_ / "two", options));
  EXPECT_TRUE(ReadTree(*folder_ / "two") == whole);
  fs::remove(*folder_ / "two/holds.csv");
  fs::remove(*folder_ / "two/scenes/drill_0000_00.toml");
  static_cast<void>(MakeRegraspSet(*folder_ / "two", options));
  EXPECT_TRUE(ReadTree(*folder_ / "two") == whole);
  WriteFileAtomically(*folder_ / "two/depth/drill_0000_00.png", "");
  fs::remove(*folder_ / "two/demonstrations.csv");
  const Written written = MakeRegraspSet(*folder_ / "two", options).written;
  EXPECT_EQ(written.num_pictures, 1U);
  EXPECT_EQ(written.num_lists, 1U);
  EXPECT_TRUE(ReadTree(*folder_ / "two") == whole);
  EXPECT_TRUE(MakeRegraspSet(*folder_ / "two", options).written.IsNothing());
}

TEST_F(SmallRegrasps, BeginALargerSet) {
  RegraspOptions options = SmallOptions();
  options.num_configurations = 1;
  options.holds_per_view = 5;
  const MadeRegrasps more = MakeRegraspSet(*folder_ / "more", options);
  EXPECT_EQ(ReadFile(*folder_ / "set/scenes/drill_0000_00.toml"),
            ReadFile(*folder_ / "more/scenes/drill_0000_00.toml"));
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(made_.holds.items[i].left.position_m, more.holds.items[i].left.position_m);
    EXPECT_EQ(made_.holds.items[i].right.position_m, more.holds.items[i].right.position_m);
  }
}

TEST(DrawRegraspPlace, LeavesTheObjectToTheRightArm) {
  const Mesh can = testing::Can(0.03F, 0.2F);
  const GraspCheck check(can, {}, {});
  Rng grasp_stream = Rng::Stream(1, "grasps");
  GraspCounts counts;
  const auto grasps = SampleGrasps(check, {.most_grasps = 100}, grasp_stream, counts);
  for (std::uint64_t i = 0; i < 20; ++i) {
    Rng rng = Rng::Stream(1, "place", i);
    const RegraspPlace place = DrawRegraspPlace(grasps, {}, rng);
    std::size_t num_reached = 0;
    for (const Grasp& grasp : grasps) {
      const Eigen::Isometry3f pose = place.base_from_object * grasp.object_from_grasp;
      EXPECT_NE(LeftArm().Check(pose, {}), GraspFault::kNone);
      num_reached += RightArm().Check(pose, {}) == GraspFault::kNone ? 1U : 0U;
    }
    EXPECT_GE(10 * num_reached, grasps.size());
    EXPECT_GE(place.angle_deg, 0.0F);
    EXPECT_LT(place.angle_deg, 360.0F);
  }
}

TEST(DrawRegraspPlace, SaysSoWhenThereIsNone) {
  Grasp from_below;
  from_below.object_from_grasp.translation().z() = 0.1F;
  Rng rng = Rng::Stream(1, "place");
  EXPECT_THROWS_MESSAGE(DrawRegraspPlace({from_below}, {}, rng),
                        Error,
                        HasSubstr("no place where the right arm alone reaches the object"));
}

TEST(BeforeLeftArm, PutsTheObjectBeforeTheMiddleOfTheRobot) {
  RegraspPlace place;
  place.base_from_object.translation() = Eigen::Vector3f(0.2F, -0.5F, 0.0F);
  const PlacedBeforeArm before = BeforeLeftArm(place);
  // The shoulder is where it would be seen from an object at (0.2, 0).
  EXPECT_NEAR(before.arm_in_base.shoulder_m.y() + 0.5F, LeftArm().shoulder_m.y(), 1e-6F);
  EXPECT_EQ(before.arm_in_base.shoulder_m.x(), LeftArm().shoulder_m.x());
}

TEST(RegraspOptions, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(RegraspOptions{.num_configurations = 0}.Validate(),
                        Error,
                        HasSubstr("RegraspOptions.num_configurations is 0"));
  EXPECT_THROWS_MESSAGE(
      RegraspOptions{.holds_per_view = 0}.Validate(), Error, HasSubstr("holds_per_view is 0"));
  EXPECT_THROWS_MESSAGE(
      RegraspOptions{.baseline_m = 2.0F}.Validate(), Error, HasSubstr("baseline_m is 2"));
  EXPECT_THROWS_MESSAGE(RegraspOptions{.family = Family::kNovel}.Validate(),
                        Error,
                        HasSubstr("RegraspOptions.family is novel"));
}

}  // namespace
}  // namespace handcraft::synthetic
