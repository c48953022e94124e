// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cell_normals.h"

#include <algorithm>
#include <cmath>

namespace handcraft::features {
namespace {

// Each cell's mean in place of its sum, from the mean of all.
void TakeMeans(std::span<CellSum> sums, const Vector3& mean) noexcept {
  for (CellSum& sum : sums) {
    if (sum.count == 0.0) continue;
    sum = {.x = sum.x / sum.count - mean[0],
           .y = sum.y / sum.count - mean[1],
           .z = sum.z / sum.count - mean[2],
           .count = 1.0};
  }
}

// What the cells of a window add up to; r and c are counted from its middle.
struct WindowSums {
  double n = 0.0;
  double r = 0.0;
  double c = 0.0;
  double rr = 0.0;
  double cc = 0.0;
  double rc = 0.0;
  Vector3 p = {};
  Vector3 rp = {};
  Vector3 cp = {};

  void Add(int row, int column, const Vector3& point) noexcept {
    const double y = row;
    const double x = column;
    n += 1.0;
    r += y;
    c += x;
    rr += y * y;
    cc += x * x;
    rc += x * y;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] += point[axis];
      rp[axis] += y * point[axis];
      cp[axis] += x * point[axis];
    }
  }

  // A vector along a × b: the determinant of the fit, which is ≥ 0, scales it alone.
  [[nodiscard]] Vector3 Normal() const noexcept {
    const double vr = n * rr - r * r;  // n² times the variances
    const double vc = n * cc - c * c;
    const double cov = n * rc - r * c;
    if (!(vr * vc - cov * cov > 0.0)) return {};
    Vector3 a;
    Vector3 b;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along_c = n * cp[axis] - c * p[axis];
      const double along_r = n * rp[axis] - r * p[axis];
      a[axis] = vr * along_c - cov * along_r;
      b[axis] = vc * along_r - cov * along_c;
    }
    return Cross(a, b);
  }
};

// Towards `direction` and of length 1; 0 stays 0.
Vector3 Oriented(const Vector3& normal, const Vector3& direction) noexcept {
  const double length = std::sqrt(Dot(normal, normal));
  if (!(length > 0.0)) return {};
  const double scale = (Dot(normal, direction) < 0.0 ? -1.0 : 1.0) / length;
  return {normal[0] * scale, normal[1] * scale, normal[2] * scale};
}

}  // namespace

std::size_t FindCellNormals(std::span<CellSum> sums,
                            int side,
                            const Vector3& mean_m,
                            const Vector3& viewpoint_m,
                            std::span<SurfacePoint> surface) noexcept {
  const auto at = [side](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
           static_cast<std::size_t>(column);
  };
  TakeMeans(sums, mean_m);
  std::size_t size = 0;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const CellSum& middle = sums[at(row, column)];
      if (middle.count == 0.0) continue;
      const Vector3 point = {middle.x, middle.y, middle.z};
      WindowSums window;
      for (int y = std::max(row - kNormalRadius, 0); y <= std::min(row + kNormalRadius, side - 1);
           ++y) {
        for (int x = std::max(column - kNormalRadius, 0);
             x <= std::min(column + kNormalRadius, side - 1);
             ++x) {
          const CellSum& sum = sums[at(y, x)];
          if (sum.count != 0.0) window.Add(y - row, x - column, {sum.x, sum.y, sum.z});
        }
      }
      surface[size++] = {point, Oriented(window.Normal(), Subtract(viewpoint_m, point))};
    }
  }
  return size;
}

}  // namespace handcraft::features
