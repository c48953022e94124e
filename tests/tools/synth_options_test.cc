// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/synth_options.h"

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/small_camera_file.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using testing::CameraFile;
using ::testing::HasSubstr;

TEST(AddSetFolder, AsksForAFolder) {
  CLI::App app;
  std::string out;
  AddSetFolder(app, out);
  EXPECT_THROW(app.parse(""), CLI::RequiredError);
  app.parse("--out made");
  EXPECT_EQ(out, "made");
}

TEST(AddCloudSensor, TakesTheNamesOfSensors) {
  using synthetic::CloudSensor;
  for (const CloudSensor sensor : {CloudSensor::kStereo,
                                   CloudSensor::kStereoBlockMatching,
                                   CloudSensor::kStereoActive,
                                   CloudSensor::kDepthCamera,
                                   CloudSensor::kPerfect}) {
    CLI::App app;
    std::string name;
    AddCloudSensor(app, name);
    app.parse("--sensor " + std::string(NameOf(sensor)));
    EXPECT_EQ(SensorNamed(name), sensor);
  }
  CLI::App app;
  std::string name;
  AddCloudSensor(app, name);
  EXPECT_THROW(app.parse("--sensor eyes"), CLI::ValidationError);
}

TEST(AddObjectFamily, TakesFamiliesOfSingleObjects) {
  CLI::App app;
  std::string family = "taught";
  AddObjectFamily(app, family);
  app.parse("--family untaught");
  EXPECT_EQ(family, "untaught");
  EXPECT_THROW(app.parse("--family trained"), CLI::ValidationError);
}

TEST(ApplyCameraFile, TakesWhatTheFileNames) {
  const TemporaryDirectory folder;
  CLI::App app;
  std::string path;
  AddCameraFile(app, path);
  app.parse("--camera " + CameraFile(folder.path()));
  synthetic::PinholeCamera camera;
  float baseline_m = 0.12F;
  ApplyCameraFile(path, camera, baseline_m);
  EXPECT_EQ(camera.width_px, 160);
  EXPECT_EQ(camera.focal_px, 131.25F);
  EXPECT_EQ(baseline_m, 0.12F);
  ApplyCameraFile(CameraFile(folder.path(), "baseline_m = 0.05\n"), camera, baseline_m);
  EXPECT_EQ(baseline_m, 0.05F);
}

TEST(ApplyCameraFile, LeavesTheCameraWithoutAFile) {
  synthetic::PinholeCamera camera;
  float baseline_m = 0.1F;
  ApplyCameraFile("", camera, baseline_m);
  EXPECT_EQ(camera.width_px, 640);
  EXPECT_EQ(baseline_m, 0.1F);
  EXPECT_THROWS_MESSAGE(
      ApplyCameraFile("no.toml", camera, baseline_m), Error, HasSubstr("No such file"));
}

TEST(TellWritten, ClaimsNoMoreThanWasDone) {
  const auto tell = [](std::size_t num_pictures, std::size_t num_lists) {
    return TellWritten(
        {.num_pictures = num_pictures, .num_lists = num_lists}, 3, "9 poses", "made");
  };
  EXPECT_EQ(tell(3, 2), "Wrote 9 poses to made\n");
  EXPECT_EQ(tell(1, 2), "Completed made, 9 poses: 2 of the 3 pictures were there\n");
  EXPECT_EQ(tell(0, 1),
            "Completed made, 9 poses: all pictures were there; a list of them was missing or told "
            "something else, and was written again\n");
  EXPECT_EQ(tell(0, 0), "Nothing to write: made is complete, 9 poses\n");
}

}  // namespace
}  // namespace handcraft::tools
