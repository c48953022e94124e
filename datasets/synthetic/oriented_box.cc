// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/oriented_box.h"

#include <algorithm>
#include <cmath>

namespace handcraft::synthetic {
namespace {

using Eigen::Matrix3f;
using Eigen::Vector3f;

constexpr float kTouchingM = 1e-6F;

// In the box's frame: whether the triangle's shadow on `axis` misses the box's. Rounding is of the
// size of the axis, and so is the margin.
bool Separates(const Vector3f& axis, const Triangle& triangle, const Vector3f& half_size_m) {
  const float a = axis.dot(triangle[0]);
  const float b = axis.dot(triangle[1]);
  const float c = axis.dot(triangle[2]);
  const float reach = half_size_m.dot(axis.cwiseAbs()) + kTouchingM * axis.norm();
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

OrientedBox MovedBox(const Eigen::AlignedBox3f& box, const Eigen::Isometry3f& frame_from_source) {
  return {frame_from_source * Eigen::Translation3f(box.center()), 0.5F * box.sizes()};
}

Eigen::AlignedBox3f Around(const OrientedBox& box) {
  const Vector3f middle = box.frame_from_box.translation();
  const Vector3f reach = box.frame_from_box.linear().cwiseAbs() * box.half_size_m;
  return {Vector3f(middle - reach), Vector3f(middle + reach)};
}

bool Overlap(const OrientedBox& a, const OrientedBox& b) {
  const Matrix3f& axes_a = a.frame_from_box.linear();
  const Matrix3f& axes_b = b.frame_from_box.linear();
  const Vector3f apart = b.frame_from_box.translation() - a.frame_from_box.translation();
  const auto separates = [&](const Vector3f& axis) {
    const float reach_a = (axes_a.transpose() * axis).cwiseAbs().dot(a.half_size_m);
    const float reach_b = (axes_b.transpose() * axis).cwiseAbs().dot(b.half_size_m);
    return std::abs(apart.dot(axis)) > reach_a + reach_b + kTouchingM * axis.norm();
  };
  for (int i = 0; i < 3; ++i) {
    if (separates(axes_a.col(i)) || separates(axes_b.col(i))) return false;
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (separates(axes_a.col(i).cross(axes_b.col(k)))) return false;
    }
  }
  return true;
}

bool Overlap(const OrientedBox& box, const Triangle& triangle) {
  const Eigen::Isometry3f box_from_frame = box.frame_from_box.inverse();
  const Triangle corners = {
      box_from_frame * triangle[0], box_from_frame * triangle[1], box_from_frame * triangle[2]};
  const std::array<Vector3f, 3> edges = {
      corners[1] - corners[0], corners[2] - corners[1], corners[0] - corners[2]};
  for (int i = 0; i < 3; ++i) {
    if (Separates(Vector3f::Unit(i), corners, box.half_size_m)) return false;
  }
  if (Separates(edges[0].cross(edges[1]), corners, box.half_size_m)) return false;
  for (int i = 0; i < 3; ++i) {
    for (const Vector3f& edge : edges) {
      if (Separates(Vector3f::Unit(i).cross(edge), corners, box.half_size_m)) return false;
    }
  }
  return true;
}

}  // namespace handcraft::synthetic
