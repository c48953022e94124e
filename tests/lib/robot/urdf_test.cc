// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/urdf.h"

#include <numbers>
#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::robot {
namespace {

using ::testing::AllOf;
using ::testing::DoubleNear;
using ::testing::HasSubstr;
using ::testing::Pointwise;

// A robot of links a, b, c, d with one line a joint.
std::string Robot(const std::string& joints) {
  return "<robot name='r'>\n<link name='a'/><link name='b'/><link name='c'/><link name='d'/>\n" +
         joints + "</robot>\n";
}

std::string JointText(const std::string& name,
                      const std::string& type,
                      const std::string& between,
                      const std::string& rest = "") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + between.substr(0, 1) +
         "'/><child link='" + between.substr(1) + "'/>" + rest + "</joint>\n";
}

Urdf Read(const std::string& text) {
  const handcraft::testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "r.urdf", text);
  return ReadUrdf(folder / "r.urdf");
}

const std::string kLimit = "<limit lower='-1' upper='2'/>";

TEST(ReadUrdf, ReadsLinksAndJoints) {
  const Urdf urdf =
      Read(Robot(JointText("j",
                           "revolute",
                           "ab",
                           "<origin xyz='1 2 3' rpy='0 0 0.5'/><axis xyz='0 0 2'/>" + kLimit) +
                 JointText("k", "continuous", "bc")));
  EXPECT_EQ(urdf.robot, "r");
  EXPECT_EQ(urdf.links.size(), 4U);
  ASSERT_EQ(urdf.joints.size(), 2U);
  EXPECT_EQ(urdf.joints[0].axis, (Vector3{0, 0, 1}));
  EXPECT_EQ(urdf.joints[0].parent_from_joint.translation_m, (Vector3{1, 2, 3}));
  EXPECT_NEAR(RotationVector(urdf.joints[0].parent_from_joint.rotation)[2], 0.5, 1e-15);
  EXPECT_EQ(urdf.joints[0].upper, 2.0);
  EXPECT_EQ(urdf.joints[1].axis, (Vector3{1, 0, 0}));
}

TEST(ReadUrdf, NamesTheLineOfWhatIsWrong) {
  const auto joint = [](const std::string& rest) {
    return Robot(JointText("j", "revolute", "ab", rest));
  };
  EXPECT_THROWS_MESSAGE(Read(""), Error, HasSubstr("r.urdf"));
  EXPECT_THROWS_MESSAGE(Read("<robot name='r'><link"), Error, HasSubstr("not XML"));
  EXPECT_THROWS_MESSAGE(Read("<sdf/>"), Error, HasSubstr("r.urdf:1: <sdf>: this is no URDF"));
  EXPECT_THROWS_MESSAGE(Read("<robot name='r'>\n<link/></robot>"),
                        Error,
                        HasSubstr("r.urdf:2: <link>: no attribute 'name'"));
  EXPECT_THROWS_MESSAGE(Read("<robot name='r'><link name='a'/><link name='a'/></robot>"),
                        Error,
                        HasSubstr("a second link 'a'"));
  EXPECT_THROWS_MESSAGE(Read(joint("<origin xyz='1 2'/>")),
                        Error,
                        HasSubstr("r.urdf:3: <origin>: xyz is '1 2'; three numbers are due"));
  EXPECT_THROWS_MESSAGE(Read(joint("<origin rpy='1 2 3 4'/>")), Error, HasSubstr("three numbers"));
  EXPECT_THROWS_MESSAGE(Read(joint("<origin xyz='1 nan 2'/>")), Error, HasSubstr("three numbers"));
  EXPECT_THROWS_MESSAGE(
      Read(joint("<axis xyz='0 0 0'/>")), Error, HasSubstr("an axis of length 0"));
  EXPECT_THROWS_MESSAGE(
      Read(joint("<limit lower='2' upper='-1'/>")),
      Error,
      AllOf(HasSubstr("limits of joint 'j' are the wrong way round"), HasSubstr("exchange them")));
  EXPECT_THROWS_MESSAGE(Read(Robot("<joint name='j' type='fixed'><parent link='a'/></joint>")),
                        Error,
                        HasSubstr("joint 'j' has no <child>"));
  EXPECT_THROWS_MESSAGE(Read(Robot(JointText("j", "fixed", "ax"))),
                        Error,
                        HasSubstr("names the link 'x', which is not there"));
  EXPECT_THROWS_MESSAGE(Read(Robot(JointText("j", "fixed", "ab") + JointText("j", "fixed", "bc"))),
                        Error,
                        HasSubstr("a second joint 'j'"));
  EXPECT_THROWS_MESSAGE(Read(Robot(JointText("j", "fixed", "ac") + JointText("k", "fixed", "bc"))),
                        Error,
                        HasSubstr("link 'c' hangs on two joints, 'j' and 'k'"));
}

TEST(ChainBetween, FoldsFixedAndLockedJointsIn) {
  const Urdf urdf = Read(
      Robot(JointText("f", "fixed", "ab", "<origin xyz='0 0 1'/>") +
            JointText("j", "revolute", "bc", "<origin xyz='1 0 0'/><axis xyz='0 0 1'/>" + kLimit) +
            JointText("k", "continuous", "cd", "<origin xyz='1 0 0'/><axis xyz='0 0 1'/>")));
  const SerialChain chain = ChainBetween(urdf, "a", "d");
  ASSERT_EQ(chain.size(), 2U);
  EXPECT_EQ(chain.joints[0].parent_from_joint.translation_m, (Vector3{1, 0, 1}));
  EXPECT_EQ(chain.joints[1].upper, std::numbers::pi);
  const SerialChain locked = ChainBetween(urdf, "a", "d", {{"j", 0.7}});
  ASSERT_EQ(locked.size(), 1U);
  const std::vector<double> both = {0.7, 0.2};
  const std::vector<double> one = {0.2};
  EXPECT_THAT(ForwardKinematics(locked, one).rotation,
              Pointwise(DoubleNear(1e-15), ForwardKinematics(chain, both).rotation));
  EXPECT_THAT(ForwardKinematics(locked, one).translation_m,
              Pointwise(DoubleNear(1e-15), ForwardKinematics(chain, both).translation_m));
}

TEST(ChainBetween, SaysWhyThereIsNoChain) {
  const Urdf urdf =
      Read(Robot(JointText("j", "revolute", "ab", kLimit) + JointText("k", "floating", "bc") +
                 JointText("m", "revolute", "ad", "<mimic joint='j'/>" + kLimit)));
  EXPECT_THROWS_MESSAGE(ChainBetween(urdf, "a", "tool"),
                        Error,
                        AllOf(HasSubstr("the tip 'tool' is no link of the robot 'r'"),
                              HasSubstr("there are: a, b, c, d")));
  EXPECT_THROWS_MESSAGE(ChainBetween(urdf, "x", "b"), Error, HasSubstr("the base 'x' is no link"));
  EXPECT_THROWS_MESSAGE(
      ChainBetween(urdf, "b", "a"), Error, HasSubstr("the tip 'a' does not hang on the base 'b'"));
  EXPECT_THROWS_MESSAGE(
      ChainBetween(urdf, "a", "c"), Error, HasSubstr("joint 'k' is of type 'floating'"));
  EXPECT_THROWS_MESSAGE(
      ChainBetween(urdf, "a", "d"), Error, HasSubstr("joint 'm' follows another joint"));
  EXPECT_THROWS_MESSAGE(ChainBetween(urdf, "a", "b", {{"k", 0.0}}),
                        Error,
                        HasSubstr("the locked joint 'k' is not between"));
  EXPECT_THROWS_MESSAGE(
      ChainBetween(urdf, "a", "a"), Error, HasSubstr("0 joints move 'a' against 'a'"));
  const Urdf unlimited = Read(Robot(JointText("j", "revolute", "ab")));
  EXPECT_THROWS_MESSAGE(
      ChainBetween(unlimited, "a", "b"), Error, HasSubstr("no room between its limits"));
}

TEST(ChainBetween, IsNotCaughtInALoop) {
  const Urdf urdf =
      Read(Robot(JointText("j", "continuous", "ab") + JointText("k", "continuous", "ba")));
  EXPECT_THROWS_MESSAGE(ChainBetween(urdf, "d", "a"), Error, HasSubstr("does not hang on"));
}

}  // namespace
}  // namespace handcraft::robot
