// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/synth_options.h"

#include "datasets/synthetic/camera_file.h"

namespace handcraft::tools {

void AddSetFolder(CLI::App& command, std::string& out) {
  command.add_option("--out", out, "Folder to make, or to go on with after a run was stopped")
      ->type_name("DIR")
      ->required();
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

}  // namespace handcraft::tools
