// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/synth_options.h"

#include <array>

#include <fmt/format.h>

#include "datasets/synthetic/camera_file.h"
#include "lib/core/utf8.h"

namespace handcraft::tools {
namespace {

using synthetic::CloudSensor;

constexpr std::array<CloudSensor, 5> kSensors = {CloudSensor::kStereo,
                                                 CloudSensor::kStereoBlockMatching,
                                                 CloudSensor::kStereoActive,
                                                 CloudSensor::kDepthCamera,
                                                 CloudSensor::kPerfect};

}  // namespace

void AddSetFolder(CLI::App& command, std::string& out) {
  command.add_option("--out", out, "Folder to make, or to go on with after a run was stopped")
      ->type_name("DIR")
      ->required();
}

void AddObjectFamily(CLI::App& command, std::string& family) {
  command
      .add_option(
          "--family",
          family,
          "taught: six kinds; untaught: eight others; regrasp: four (docs/synthetic_data.md)")
      ->check(CLI::IsMember({"taught", "untaught", "regrasp"}))
      ->capture_default_str();
}

void AddCloudSensor(CLI::App& command, std::string& sensor) {
  command
      .add_option("--sensor",
                  sensor,
                  "What measures the cloud: stereo (semi-global matching), stereo-bm (block "
                  "matching), stereo-active (with a projector of dots), depth-camera, perfect")
      ->check(CLI::IsMember({"stereo", "stereo-bm", "stereo-active", "depth-camera", "perfect"}))
      ->capture_default_str();
}

CloudSensor SensorNamed(std::string_view name) {
  for (const CloudSensor sensor : kSensors) {
    if (NameOf(sensor) == name) return sensor;
  }
  return CloudSensor::kStereo;  // the command line lets no other name pass
}

void AddCameraFile(CLI::App& command, std::string& path) {
  command
      .add_option("--camera",
                  path,
                  "TOML file whose table [camera] has other intrinsics, and another baseline")
      ->type_name("FILE");
}

void ApplyCameraFile(const std::string& path, synthetic::PinholeCamera& camera, float& baseline_m) {
  if (path.empty()) return;
  const synthetic::CameraFile file = synthetic::ReadCameraFile(path);
  camera = file.camera;
  baseline_m = file.baseline_m.value_or(baseline_m);
}

std::string TellWritten(const synthetic::Written& written,
                        std::size_t num_pictures,
                        const std::string& contents,
                        const std::string& out) {
  const std::string folder = OnOneLine(out);
  if (written.IsNothing()) {
    return fmt::format("Nothing to write: {} is complete, {}\n", folder, contents);
  }
  if (written.num_pictures == num_pictures) {
    return fmt::format("Wrote {} to {}\n", contents, folder);
  }
  if (written.num_pictures == 0) {
    return fmt::format(
        "Completed {}, {}: all pictures were there; a list of them was missing or told something "
        "else, and was written again\n",
        folder,
        contents);
  }
  return fmt::format("Completed {}, {}: {} of the {} pictures were there\n",
                     folder,
                     contents,
                     num_pictures - written.num_pictures,
                     num_pictures);
}

}  // namespace handcraft::tools
