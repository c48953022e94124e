// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <Eigen/Geometry>

namespace handcraft::synthetic {

/// A pinhole camera without distortion; its optical frame has z forward, x right, y down. Rays are
/// scaled so that their parameter is the depth along the optical axis [m].
struct PinholeCamera {
  int width_px = 640;
  int height_px = 480;
  float focal_px = 525.0F;
  float centre_u_px = 319.5F;
  float centre_v_px = 239.5F;
  Eigen::Isometry3f base_from_camera = Eigen::Isometry3f::Identity();

  [[nodiscard]] Eigen::Vector3f Origin() const { return base_from_camera.translation(); }
  /// Direction of the ray through (u, v), one metre of depth long.
  [[nodiscard]] Eigen::Vector3f Ray(float u_px, float v_px) const;
  /// Where a point in front of the camera is seen.
  [[nodiscard]] Eigen::Vector2f Project(const Eigen::Vector3f& p_in_base) const;

  /// Throws Error(kUsage) naming field, value and rule when the intrinsics are of no camera: sides
  /// from 16 to 4096 pixels, focal length and centre within ten times the longer side.
  void Validate() const;
};

/// Pose of a camera that looks from one point to another, the picture's vertical along z, then
/// rolled about the optical axis.
[[nodiscard]] Eigen::Isometry3f LookAt(const Eigen::Vector3f& from_m,
                                       const Eigen::Vector3f& to_m,
                                       float roll_rad);

/// The other camera of a rectified pair, moved to the right by the baseline.
[[nodiscard]] PinholeCamera RightOf(const PinholeCamera& left, float baseline_m);

}  // namespace handcraft::synthetic
