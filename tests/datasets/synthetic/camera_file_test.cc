// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/camera_file.h"

#include <string>

#include "datasets/synthetic/scene_files.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::synthetic {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;

class CameraFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] CameraFile Read(const std::string& text) const {
    WriteFileAtomically(folder_ / "camera.toml", text);
    return ReadCameraFile(folder_ / "camera.toml");
  }
  void ExpectRefused(const std::string& text, const std::string& message) const {
    EXPECT_THROWS_MESSAGE(Read(text), Error, HasSubstr(message));
  }

  const std::string good_ =
      "[camera]\nwidth_px = 320\nheight_px = 240\nfocal_px = 262.5\ncentre_u_px = 160\n"
      "centre_v_px = 119.5\n";
  TemporaryDirectory folder_;
};

TEST_F(CameraFileTest, ReadsIntrinsicsAndBaseline) {
  const CameraFile file = Read(good_ + "baseline_m = 0.065\n[lens]\nmade = 'glass'\n");
  EXPECT_EQ(file.camera.width_px, 320);
  EXPECT_EQ(file.camera.height_px, 240);
  EXPECT_EQ(file.camera.focal_px, 262.5F);
  EXPECT_EQ(file.camera.centre_u_px, 160.0F) << "a whole number is one too";
  EXPECT_EQ(file.camera.centre_v_px, 119.5F);
  EXPECT_EQ(file.baseline_m, 0.065F);
  EXPECT_EQ(Read(good_).baseline_m, std::nullopt);
}

TEST_F(CameraFileTest, ReadsWhatSetsTellOfTheirCamera) {
  const PinholeCamera camera{.width_px = 321, .focal_px = 525.3712F, .centre_v_px = 0.1F};
  const CameraFile file = Read("kind = \"moved\"\n" + CameraToToml(camera, 0.12F));
  EXPECT_EQ(file.camera.width_px, camera.width_px);
  EXPECT_EQ(file.camera.focal_px, camera.focal_px);
  EXPECT_EQ(file.camera.centre_v_px, camera.centre_v_px);
  EXPECT_EQ(file.baseline_m, 0.12F);
}

TEST_F(CameraFileTest, RefusesOtherFiles) {
  ExpectRefused("", "camera.toml: no table [camera]");
  ExpectRefused("camera = 3\n", "no table [camera]");
  ExpectRefused("[camera]\nwidth_px 320\n", "camera.toml:2: not TOML: ");
  ExpectRefused("[camera\n", "camera.toml:1: not TOML: ");
  ExpectRefused("\xff\xfe", "not TOML: ");
  EXPECT_THROWS_MESSAGE(ReadCameraFile(folder_ / "no.toml"), Error, HasSubstr("No such file"));
}

TEST_F(CameraFileTest, RefusesValuesOfNoCamera) {
  ExpectRefused("[camera]\nwidth_px = 320\n", "camera.toml:1: no height_px in [camera]");
  ExpectRefused("[camera]\nwidth_px = 320.0\n", "camera.toml:2: width_px is no whole number");
  ExpectRefused("[camera]\nwidth_px = '320'\n", "camera.toml:2: width_px is no whole number");
  ExpectRefused(good_ + "baseline_m = 'wide'\n", "camera.toml:7: baseline_m is no number");
  ExpectRefused(good_ + "baseline_m = -1\n", "camera.toml:7: baseline_m is -1; it must be in (0");
  ExpectRefused(good_ + "baseline_m = nan\n", "baseline_m is nan");
  ExpectRefused(good_ + "baseline_m = -0.12\n", "baseline_m is -0.12; it must be");
  ExpectRefused(good_ + "fx = 3\n",
                "camera.toml:7: 'fx' is no key of [camera] (there are width_px");
  std::string huge = good_;
  huge.replace(huge.find("320"), 3, "9223372036854775807");
  ExpectRefused(good_ + "baseline_m = 1.5\n[lens]\n", "camera.toml:7: baseline_m is 1.5; it must");
  std::string wide = good_;
  wide.replace(wide.find("262.5"), 5, "0.5");
  ExpectRefused(wide,
                "camera.toml:4: focal_px is 0.5; it must be 1 or more and up to 3200, ten times");
  std::string far = good_;
  far.replace(far.find("119.5"), 5, "-1e9");
  ExpectRefused(far, "camera.toml:6: centre_v_px is -1");
  ExpectRefused(huge, "camera.toml:2: width_px is 2147483647; it must be from 16");
}

}  // namespace
}  // namespace handcraft::synthetic
