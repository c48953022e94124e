// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/pose_columns.h"

#include <cmath>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryDirectory;

EndEffectorPose ReadFields(const std::string& fields) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "poses.csv", "x_m,y_m,z_m,qx,qy,qz,qw\n" + fields + "\n");
  CsvRows rows(folder / "poses.csv", kPoseColumns);
  EXPECT_TRUE(rows.Next());
  return ReadPose(rows, 0);
}

Eigen::Isometry3d DrawPose(Rng& rng) {
  const auto normals = [&] { return Eigen::Vector3d(rng.Normal(), rng.Normal(), rng.Normal()); };
  const Eigen::Vector3d axis = normals().normalized();
  return Eigen::Translation3d(normals()) * Eigen::AngleAxisd(6.0 * rng.Uniform() - 3.0, axis);
}

TEST(ReadPose, ReadsPositionAndQuaternion) {
  const double half = std::sqrt(0.5);
  const EndEffectorPose pose = ReadFields("0.1,-0.2,0.3,0,0,0.7071067811865476,0.7071067811865476");
  EXPECT_EQ(pose.position_m, Eigen::Vector3d(0.1, -0.2, 0.3));
  EXPECT_EQ(pose.rotation.w(), half);
  // A quarter turn about z takes x to y.
  const Eigen::Vector3d turned = pose.ToIsometry() * Eigen::Vector3d(1.0, 0.0, 0.0);
  EXPECT_TRUE(turned.isApprox(Eigen::Vector3d(0.1, 0.8, 0.3), 1e-12));
}

TEST(ReadPose, NormalisesOnlyWhatItReturnsAsAMotion) {
  const EndEffectorPose pose = ReadFields("0,0,0,0,0,0,1.0009");
  EXPECT_EQ(pose.rotation.w(), 1.0009) << "kept as it was read";
  EXPECT_TRUE(pose.ToIsometry().linear().isApprox(Eigen::Matrix3d::Identity(), 1e-12));
}

TEST(ReadPose, RefusesWhatIsNoPose) {
  EXPECT_THROWS_MESSAGE(ReadFields("0,0,0,0,0,0,1.002"),
                        Error,
                        HasSubstr("poses.csv:2: the quaternion has length 1.002; 1 is due"));
  EXPECT_THROWS_MESSAGE(ReadFields("0,0,0,0,0,0,0"), Error, HasSubstr("has length 0"));
  EXPECT_THROWS_MESSAGE(ReadFields("0,0,0,1e300,0,0,1e300"), Error, HasSubstr("has length"));
  EXPECT_THROWS_MESSAGE(
      ReadFields("0,350,0,0,0,0,1"), Error, HasSubstr("'y_m': 350 m is out of a robot's reach"));
  EXPECT_THROWS_MESSAGE(ReadFields("0,0,nan,0,0,0,1"), Error, HasSubstr("'z_m': 'nan' is not"));
  EXPECT_THROWS_MESSAGE(ReadFields("0,0,0,0,0,inf,1"), Error, HasSubstr("'qz': 'inf' is not"));
}

TEST(CheckFrames, TakesTheOneFrameAndEndEffector) {
  const TemporaryDirectory folder;
  WriteFileAtomically(
      folder / "poses.csv",
      "frame,end_effector\n" + FrameFields() + "\ncamera,grasp_centre\nbase,tool0\n");
  CsvRows rows(folder / "poses.csv", kFrameColumns);
  ASSERT_TRUE(rows.Next());
  CheckFrames(rows, 0);
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      CheckFrames(rows, 0), Error, HasSubstr("poses.csv:3: frame 'camera'; 'base' is due (bring"));
  ASSERT_TRUE(rows.Next());
  EXPECT_THROWS_MESSAGE(
      CheckFrames(rows, 0), Error, HasSubstr(":4: end_effector 'tool0'; 'grasp_centre' is due"));
}

TEST(PoseFields, ComeBackAsTheyWere) {
  Rng rng = Rng::Stream(1, "poses");
  for (int i = 0; i < 50; ++i) {
    const Eigen::Isometry3d drawn = DrawPose(rng);
    const EndEffectorPose pose{.position_m = drawn.translation(),
                               .rotation = Eigen::Quaterniond(drawn.linear())};
    const EndEffectorPose read = ReadFields(PoseFields(pose));
    EXPECT_EQ(read.position_m, pose.position_m);
    EXPECT_EQ(read.rotation.coeffs(), pose.rotation.coeffs());
  }
}

TEST(RoundedPose, KeepsThePoseToAMicrometre) {
  Rng rng = Rng::Stream(2, "poses");
  for (int i = 0; i < 50; ++i) {
    const Eigen::Isometry3d drawn = DrawPose(rng);
    const EndEffectorPose rounded = EndEffectorPose::Rounded(drawn);
    EXPECT_TRUE(rounded.ToIsometry().isApprox(drawn, 3e-6));
    EXPECT_GE(rounded.rotation.w(), 0.0);
    EXPECT_LE(PoseFields(rounded).size(), 7U * 10U) << "few digits";
  }
  EXPECT_EQ(PoseFields(EndEffectorPose::Rounded(Eigen::Isometry3d::Identity())), "0,0,0,0,0,0,1");
}

}  // namespace
}  // namespace handcraft::datasets
