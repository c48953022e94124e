// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/camera.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/core/option_rules.h"

namespace handcraft::synthetic {

using Eigen::Vector3f;

Vector3f PinholeCamera::Ray(float u_px, float v_px) const {
  const Vector3f in_camera((u_px - centre_u_px) / focal_px, (v_px - centre_v_px) / focal_px, 1.0F);
  return base_from_camera.linear() * in_camera;
}

Eigen::Vector2f PinholeCamera::Project(const Vector3f& p_in_base) const {
  const Vector3f p = base_from_camera.inverse() * p_in_base;
  return {centre_u_px + focal_px * p.x() / p.z(), centre_v_px + focal_px * p.y() / p.z()};
}

void PinholeCamera::Validate() const {
  constexpr int kLeastSidePx = 16;
  constexpr int kMostSidePx = 4096;
  const auto require_side = [](const std::string& field, int value) {
    RequireOption(value >= kLeastSidePx && value <= kMostSidePx, field, value, "from 16 to 4096");
  };
  require_side("PinholeCamera.width_px", width_px);
  require_side("PinholeCamera.height_px", height_px);
  const auto most = 10.0F * static_cast<float>(std::max(width_px, height_px));
  const std::string within = "up to " + NumberToText(most) + ", ten times the longer side";
  RequireOption(focal_px >= 1.0F && focal_px <= most,
                "PinholeCamera.focal_px",
                focal_px,
                "1 or more and " + within);
  const auto require_centre = [&](const std::string& field, float value) {
    RequireOption(std::abs(value) <= most, field, value, within + ", either way from 0");
  };
  require_centre("PinholeCamera.centre_u_px", centre_u_px);
  require_centre("PinholeCamera.centre_v_px", centre_v_px);
}

Eigen::Isometry3f LookAt(const Vector3f& from_m, const Vector3f& to_m, float roll_rad) {
  const Vector3f forward = (to_m - from_m).normalized();
  const Vector3f right = forward.cross(Vector3f::UnitZ()).normalized();
  Eigen::Isometry3f pose = Eigen::Isometry3f::Identity();
  pose.linear().col(0) = right;
  pose.linear().col(1) = forward.cross(right);
  pose.linear().col(2) = forward;
  pose.translation() = from_m;
  return pose * Eigen::AngleAxisf(roll_rad, Vector3f::UnitZ());
}

PinholeCamera RightOf(const PinholeCamera& left, float baseline_m) {
  PinholeCamera right = left;
  right.base_from_camera.translation() += baseline_m * left.base_from_camera.linear().col(0);
  return right;
}

}  // namespace handcraft::synthetic
