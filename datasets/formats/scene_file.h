// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace handcraft::datasets {

/// Checks a file that tells the poses of a picture's camera and objects (docs/datasets.md, Scene):
/// class and instance, [camera] with base_from_camera, one [[objects]] or more with
/// base_from_object; each pose a position [m] of three numbers and a quaternion x, y, z, w whose
/// length is 1 within 0.001. Throws Error with the line, or what is missing.
void CheckSceneFile(const std::filesystem::path& path);

}  // namespace handcraft::datasets
