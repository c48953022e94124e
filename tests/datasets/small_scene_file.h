// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

namespace handcraft::testing {

/// A scene file of one object, half a metre before the camera.
inline constexpr std::string_view kSmallSceneFile =
    "class = \"mug\"\n"
    "instance = 3\n"
    "\n"
    "[camera]\n"
    "base_from_camera_position_m = [0, 0, 0.5]\n"
    "base_from_camera_quaternion_xyzw = [1, 0.0, 0, 0]\n"
    "\n"
    "[[objects]]\n"
    "base_from_object_position_m = [0.25, 1e-3, 0]\n"
    "base_from_object_quaternion_xyzw = [0, 0, 0.6, 0.8]\n";

}  // namespace handcraft::testing
