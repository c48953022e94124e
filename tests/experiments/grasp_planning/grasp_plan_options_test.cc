// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/grasp_planning/grasp_plan_options.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class GraspPlanFile : public ::testing::Test {
 protected:
  GraspPlanOptions Read(const std::string& text) {
    WriteFileAtomically(folder_ / "plan.toml", text);
    return ReadGraspPlanFile(folder_ / "plan.toml");
  }

  testing::TemporaryDirectory folder_;
};

TEST_F(GraspPlanFile, NamesEachComponent) {
  const GraspPlanOptions options = Read(R"(
[grasp_point]
pixel = [320, 240]
[object_class]
name = "mug"
[grasp_library]
model = "library.safetensors"
neighbours = 3
position = "grasp_point"
attempts = 5
attempt_distance_m = 0.03
[robot]
file = "/robots/arm.toml"
any_arm = true
reference = [0.0, 1, -0.5]
[hand]
grasp_centre_m = [0, 0, 0.1]
grasp_centre_xyzw = [0, 0, 1, 0]
)");
  EXPECT_EQ(options.grasp_pixel, (std::array<int, 2>{320, 240}));
  EXPECT_EQ(options.object_class, "mug");
  EXPECT_EQ(options.grasp_library, folder_ / "library.safetensors");
  EXPECT_EQ(options.num_neighbours, 3);
  EXPECT_EQ(options.position, GraspPosition::kGraspPoint);
  EXPECT_EQ(options.max_attempts, 5);
  EXPECT_EQ(options.max_attempt_distance_m, 0.03);
  EXPECT_EQ(options.robot, "/robots/arm.toml");
  EXPECT_TRUE(options.any_arm);
  EXPECT_EQ(options.reference_joints, (std::vector<double>{0.0, 1.0, -0.5}));
  EXPECT_EQ(options.grasp_centre_m[2], 0.1);
  EXPECT_EQ(options.grasp_centre_xyzw[2], 1.0);
  options.Validate();
}

TEST_F(GraspPlanFile, AnotherComponentIsAnotherLine) {
  const GraspPlanOptions options = Read("[grasp_point]\nmodel = \"points.safetensors\"\n");
  EXPECT_EQ(options.grasp_point_model, folder_ / "points.safetensors");
  EXPECT_FALSE(options.grasp_pixel.has_value());
}

TEST_F(GraspPlanFile, OfNothingLeavesTheDefaults) {
  const GraspPlanOptions options = Read("");
  EXPECT_EQ(options.num_neighbours, 1);
  EXPECT_EQ(options.position, GraspPosition::kDemonstration);
  EXPECT_EQ(options.grasp_centre_m[2], 0.175);
}

TEST_F(GraspPlanFile, TellsFileAndLineOfFaults) {
  EXPECT_THROWS_MESSAGE(Read("[arm]\n"), Error, HasSubstr("plan.toml:1: \"arm\" is no key"));
  EXPECT_THROWS_MESSAGE(Read("[robot]\nfiles = \"a\"\n"),
                        Error,
                        AllOf(HasSubstr("plan.toml:2"), HasSubstr("\"files\" is no key")));
  EXPECT_THROWS_MESSAGE(Read("[grasp_point]\npixel = [1.5, 2]\n"),
                        Error,
                        AllOf(HasSubstr("plan.toml:2"), HasSubstr("whole numbers from 0")));
  EXPECT_THROWS_MESSAGE(Read("[grasp_point]\npixel = [1]\n"),
                        Error,
                        HasSubstr("'pixel' must be a list of 2 numbers"));
  EXPECT_THROWS_MESSAGE(Read("[robot]\nreference = [0, nan]\n"),
                        Error,
                        HasSubstr("'reference' must be a list of numbers"));
  EXPECT_THROWS_MESSAGE(
      Read("[robot]\nany_arm = 1\n"), Error, HasSubstr("'any_arm' must be true or false"));
  EXPECT_THROWS_MESSAGE(Read("[grasp_library]\nposition = \"here\"\n"),
                        Error,
                        HasSubstr("must be \"grasp_point\" or \"demonstration\""));
  EXPECT_THROWS_MESSAGE(
      Read("[grasp_library]\nneighbours = 33\n"), Error, HasSubstr("a number from 1 to 32"));
  EXPECT_THROWS_MESSAGE(
      Read("[grasp_library]\nattempts = 65\n"), Error, HasSubstr("a number from 1 to 64"));
  EXPECT_THROWS_MESSAGE(
      Read("[object_class]\nnone_of_these = \"stop\"\n"),
      Error,
      AllOf(HasSubstr("plan.toml:2"), HasSubstr("must be \"refuse\" or \"nearest\"")));
  EXPECT_THROWS_MESSAGE(Read("[hand]\ngrasp_centre_xyzw = [0, 0, 0, 2]\n"),
                        Error,
                        AllOf(HasSubstr("plan.toml:2"), HasSubstr("of length 1: x, y, z, w")));
}

TEST_F(GraspPlanFile, SaysWhatBecomesOfAnObjectOfNoClass) {
  EXPECT_FALSE(Read("").take_nearest_class);
  EXPECT_FALSE(Read("[object_class]\nnone_of_these = \"refuse\"\n").take_nearest_class);
  EXPECT_TRUE(Read("[object_class]\nnone_of_these = \"nearest\"\n").take_nearest_class);
}

GraspPlanOptions Whole() {
  GraspPlanOptions options;
  options.grasp_pixel = {1, 2};
  options.object_class = "mug";
  options.grasp_library = "l";
  options.robot = "r";
  return options;
}

TEST(GraspPlanOptions, SaysWhatIsMissing) {
  Whole().Validate();
  GraspPlanOptions options = Whole();
  options.grasp_library.clear();
  EXPECT_THROWS_MESSAGE(
      options.Validate(), Error, AllOf(HasSubstr("the grasp library"), HasSubstr("--library")));
  options = Whole();
  options.robot.clear();
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("the arm is not told"));
  options = Whole();
  options.object_class.clear();
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("the object's class is not told"));
  options = Whole();
  options.grasp_pixel.reset();
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("where to grasp is not told"));
}

TEST(GraspPlanOptions, RefusesContradictionsAndNoRotation) {
  GraspPlanOptions options = Whole();
  options.grasp_point_model = "m";
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("told twice"));
  options = Whole();
  options.num_neighbours = 0;
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("num_neighbours is 0"));
  options = Whole();
  options.max_attempts = 65;
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("max_attempts is 65"));
  options = Whole();
  options.max_attempt_distance_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("max_attempt_distance_m is nan"));
  options = Whole();
  options.grasp_centre_xyzw = {0, 0, 0, 0};
  EXPECT_THROWS_MESSAGE(options.Validate(), Error, HasSubstr("grasp_centre_xyzw is 0"));
}

}  // namespace
}  // namespace handcraft::experiments
