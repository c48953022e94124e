// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>

#include "datasets/synthetic/camera.h"

namespace handcraft::synthetic {

/// Intrinsics of a camera, and the baseline where it is the left one of a pair.
struct CameraFile {
  PinholeCamera camera;  ///< its pose is not set
  std::optional<float> baseline_m;
};

/// Reads the table [camera] of a TOML file, as dataset.toml of a made-up set has it: whole numbers
/// width_px and height_px, numbers focal_px, centre_u_px and centre_v_px, and, not needed,
/// baseline_m in (0, 1]. Other tables are passed over. Throws Error with the line: text that is not
/// TOML, a value that is missing, unknown or of another type, intrinsics of no camera.
[[nodiscard]] CameraFile ReadCameraFile(const std::filesystem::path& path);

}  // namespace handcraft::synthetic
