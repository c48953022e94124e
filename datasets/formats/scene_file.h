// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>

namespace handcraft::datasets {

/// What a scene file tells of a picture (docs/datasets.md, Scene).
struct SceneRecord {
  std::string object_class;
  std::int64_t instance = 0;
  Eigen::Isometry3d base_from_camera = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Isometry3d> base_from_objects = {};  ///< one or more
  double scale = 1.0;  ///< by which the objects are larger than they were built
};

/// Reads a file that tells the poses of a picture's camera and objects: class and instance,
/// [camera] with base_from_camera, one [[objects]] or more with base_from_object; each pose a
/// position [m] of three numbers and a quaternion x, y, z, w whose length is 1 within 0.001, which
/// is normalised. A scale, above 0, may be missing. Throws Error with the line, or what is missing.
[[nodiscard]] SceneRecord ReadSceneFile(const std::filesystem::path& path);

}  // namespace handcraft::datasets
