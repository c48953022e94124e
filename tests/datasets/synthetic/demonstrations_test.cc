// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/demonstrations.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

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
using ::testing::SizeIs;
using testing::SmallCamera;

// Small views of four objects, with clouds without fault: fast.
DemonstrationOptions SmallOptions(int num_views, int poses_per_view) {
  DemonstrationOptions options;
  options.views.family = Family::kRegrasp;
  options.views.num_views = num_views;
  options.views.sensor = CloudSensor::kPerfect;
  options.views.camera = SmallCamera();
  options.poses_per_view = poses_per_view;
  options.sampler.num_tries = 4000;
  options.sampler.most_grasps = 100;
  return options;
}

// The poses of one view.
std::vector<datasets::EndEffectorPose> PosesOf(const datasets::DemonstrationSet& set,
                                               const std::string& view) {
  std::vector<datasets::EndEffectorPose> poses;
  for (const datasets::Demonstration& item : set.items) {
    if (item.view == view) poses.push_back(item.pose);
  }
  return poses;
}

TEST(NumPoses, AreThoseOfTheDissertation) {
  DemonstrationOptions full;
  full.quota = PoseQuota::kFull;
  const std::map<std::string, int, std::less<>> expected = {{"coffee_can", 5607},
                                                            {"drill", 3623},
                                                            {"mouthwash_bottle", 3619},
                                                            {"mug", 1795},
                                                            {"detergent_bottle", 4419},
                                                            {"plastic_bottle", 4885}};
  int all = 0;
  for (const ObjectClass& kind : ClassesOf(Family::kTaught)) {
    int of_class = 0;
    for (int view = 0; view < 12; ++view) {
      const int count = NumPoses(kind, view, full);
      EXPECT_GE(count, 126) << "section 4.2.1.2";
      EXPECT_LE(count, 525);
      of_class += count;
    }
    EXPECT_EQ(of_class, expected.find(kind.name)->second);
    all += of_class;
  }
  EXPECT_EQ(all, 23948) << "the sum of the rows; the table says 23984";
  full.views.family = Family::kUntaught;
  EXPECT_EQ(NumPoses(ClassesOf(Family::kUntaught)[0], 3, full), 333);
  EXPECT_EQ(NumPoses(ClassesOf(Family::kTaught)[0], 3, {}), 40);
}

// A set of two views and two poses a class, made once.
class SmallDemonstrations : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryDirectory>();
    made_ = MakeDemonstrations(*folder_ / "set", SmallOptions(2, 2));
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static inline std::unique_ptr<TemporaryDirectory> folder_;
  static inline MadeDemonstrations made_;
};

TEST_F(SmallDemonstrations, AreASoundSet) {
  const datasets::DemonstrationSet set = datasets::ReadDemonstrationSet(*folder_ / "set");
  EXPECT_EQ(datasets::Fingerprint(set), datasets::Fingerprint(made_.set));
  EXPECT_THAT(set.items, SizeIs(4 * 2 * 2));
  EXPECT_THAT(datasets::FindFaults(datasets::ReadViewSet(*folder_ / "set")), ::testing::IsEmpty());
  ASSERT_THAT(made_.reports, SizeIs(4));
  for (const ClassReport& report : made_.reports) {
    EXPECT_EQ(report.num_poses, 4U);
    EXPECT_EQ(report.shown[GraspFault::kNone], 4U);
    EXPECT_GT(report.least_width_m, 0.0F);
    EXPECT_LE(report.least_width_m, report.mean_width_m);
    EXPECT_LE(report.mean_width_m, report.greatest_width_m);
    EXPECT_LE(report.greatest_width_m, Gripper{}.WidestM());
  }
  EXPECT_THAT(ReadTextFile(*folder_ / "set/dataset.toml"), HasSubstr("kind = \"demonstrations\""));
}

TEST_F(SmallDemonstrations, HoldTheObjectOfEachView) {
  const ObjectClass& kind = ClassesOf(Family::kRegrasp)[2];
  const Object object = DrawInstance(kind, 1, 0);
  int num_poses = 0;
  for (const datasets::Demonstration& item : made_.set.items) {
    if (item.object_class != kind.name) continue;
    ++num_poses;
    const Eigen::Isometry3f base_from_object =
        TurntablePose(static_cast<float>(item.angle_deg.value()));
    EXPECT_EQ(testing::SlowClose(object.mesh, {}, {}, InObject(item.pose, base_from_object), 2e-5),
              GraspFault::kNone);
    EXPECT_EQ(RightArm().Check(item.pose.ToIsometry().cast<float>(), {}), GraspFault::kNone);
  }
  EXPECT_EQ(num_poses, 4);
}

TEST_F(SmallDemonstrations, BeginALargerSetWithFewerViews) {
  const MadeDemonstrations more = MakeDemonstrations(*folder_ / "more", SmallOptions(1, 4));
  const std::string view = "images/drill_0000_00.png";
  const auto first = PosesOf(made_.set, view);
  const auto all = PosesOf(more.set, view);
  ASSERT_THAT(first, SizeIs(2));
  ASSERT_THAT(all, SizeIs(4));
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].position_m, all[i].position_m);
    EXPECT_EQ(first[i].rotation.coeffs(), all[i].rotation.coeffs());
  }
}

TEST_F(SmallDemonstrations, AreTheSameBytesForAnyNumberOfThreadsAndAfterAStop) {
  const auto whole = ReadTree(*folder_ / "set");
  DemonstrationOptions options = SmallOptions(2, 2);
  options.views.num_threads = 2;
  static_cast<void>(MakeDemonstrations(*folder_ / "two", options));
  EXPECT_TRUE(ReadTree(*folder_ / "two") == whole);
  fs::remove(*folder_ / "two/demonstrations.csv");
  fs::remove(*folder_ / "two/views.csv");
  fs::remove(*folder_ / "two/scenes/drill_0000_01.toml");
  const auto kept = fs::last_write_time(*folder_ / "two/images/drill_0000_00.png");
  static_cast<void>(MakeDemonstrations(*folder_ / "two", options));
  EXPECT_TRUE(ReadTree(*folder_ / "two") == whole);
  EXPECT_EQ(fs::last_write_time(*folder_ / "two/images/drill_0000_00.png"), kept);
  EXPECT_TRUE(MakeDemonstrations(*folder_ / "two", options).written.IsNothing());
  fs::remove(*folder_ / "two/clouds/drill_0000_01.pcd");
  fs::resize_file(*folder_ / "two/demonstrations.csv", 500);
  const Written written = MakeDemonstrations(*folder_ / "two", options).written;
  EXPECT_EQ(written.num_pictures, 1U);
  EXPECT_EQ(written.num_lists, 1U);
  EXPECT_TRUE(ReadTree(*folder_ / "two") == whole);
}

TEST_F(SmallDemonstrations, AreNotMadeByAHandThatIsTooSmall) {
  DemonstrationOptions options = SmallOptions(1, 1);
  options.gripper.max_opening_m = 0.02F;
  options.gripper.knuckle_m = 0.01F;
  EXPECT_THROWS_MESSAGE(MakeDemonstrations(*folder_ / "small_hand", options),
                        Error,
                        HasSubstr("the hand cannot hold the water_bottle: of "));
}

TEST_F(SmallDemonstrations, AreNotGoneOnWithByAnotherNumberOfPoses) {
  EXPECT_THROWS_MESSAGE(MakeDemonstrations(*folder_ / "set", SmallOptions(2, 3)),
                        Error,
                        HasSubstr("tells of a set made with other options"));
}

TEST(DemonstrationOptions, RefuseWhatCannotBe) {
  EXPECT_THROWS_MESSAGE(DemonstrationOptions{.poses_per_view = -1}.Validate(),
                        Error,
                        HasSubstr("DemonstrationOptions.poses_per_view is -1"));
  DemonstrationOptions options;
  options.views.family = Family::kTrained;
  EXPECT_THROWS_MESSAGE(
      options.Validate(), Error, HasSubstr("must be taught, untaught or regrasp"));
}

}  // namespace
}  // namespace handcraft::synthetic
