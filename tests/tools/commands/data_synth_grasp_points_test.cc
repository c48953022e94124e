// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/file.h"
#include "tests/tools/support/synth_test.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;
using ::testing::StartsWith;

class DataSynthGraspPoints : public testing::SynthTest {
 protected:
  [[nodiscard]] Outcome Make(const std::string& options) const {
    return Synth("grasp-points", options);
  }
};

TEST_F(DataSynthGraspPoints, MakesASetThatPassesTheCheck) {
  const Outcome outcome = Make("--images 2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("Wrote 2 images with masks to "));
  const Outcome check = RunLine("data check " + out_.string());
  EXPECT_EQ(check.code, 0) << check.out << check.err;
}

TEST_F(DataSynthGraspPoints, ClaimsToHaveWrittenOnlyWhatItHas) {
  ASSERT_EQ(Make("--images 2").code, 0);
  const Outcome again = Make("--images 2");
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(again.out,
            "Nothing to write: " + out_.string() + " is complete, 2 images with masks\n");
  EXPECT_EQ(nlohmann::json::parse(Make("--images 2 --json").out)["num_images_written"], 0);
  std::filesystem::remove(out_ / "masks/eraser_0000_0.png");
  EXPECT_EQ(
      Make("--images 2").out,
      "Completed " + out_.string() + ", 2 images with masks: 1 of the 2 pictures were there\n");
  const Outcome other = Make("--images 3");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("num_images = 2 there, num_images = 3 here"));
}

TEST_F(DataSynthGraspPoints, TakesItsOptions) {
  const Outcome outcome = Make("--images 1 --family novel --seed 5 --stereo --threads 1 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["num_images"], 1);
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(out_);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(set));
  EXPECT_EQ(set.items[0].object_class, "bottle");
  EXPECT_TRUE(std::filesystem::exists(out_ / "images/bottle_0000_0_right.png"));
  EXPECT_THAT(ReadTextFile(out_ / "dataset.toml"), HasSubstr("seed = 5\n"));
}

TEST_F(DataSynthGraspPoints, LeavesOutTheSurroundingsWhenAsked) {
  ASSERT_EQ(Make("--images 1 --surroundings bare").code, 0);
  EXPECT_THAT(ReadTextFile(out_ / "dataset.toml"), HasSubstr("surroundings = \"bare\"\n"));
  const Outcome other = Make("--images 1");
  EXPECT_EQ(other.code, 2) << "made with other options";
}

TEST_F(DataSynthGraspPoints, RefusesOptionsThatContradictAndValuesItDoesNotKnow) {
  EXPECT_EQ(Make("--images 2 --size full").code, 2);
  EXPECT_THAT(Make("--images -1").err, HasSubstr("--images: -1 given; it must be from 1 to"));
  EXPECT_THAT(Make("--images 0").err, HasSubstr("--images: 0 given; it must be from 1 to 1000000"));
  EXPECT_EQ(Make("--family old").code, 2);
  EXPECT_EQ(Make("--size huge").code, 2);
  EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(DataSynthGraspPoints, RefusesAFolderOfOthers) {
  std::filesystem::create_directory(out_);
  WriteFileAtomically(out_ / "mine", "precious");
  const Outcome outcome = Make("--images 1");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("is not an empty folder"));
  EXPECT_EQ(ReadTextFile(out_ / "mine"), "precious");
}

}  // namespace
}  // namespace handcraft::tools
