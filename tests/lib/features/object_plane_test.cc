// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/object_plane.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "lib/core/rng.h"
#include "tests/lib/features/some_cloud.h"

namespace handcraft::features {
namespace {

using testing::SomeCloud;

double AbsoluteDot(const Vector3& a, const Vector3& b) {
  return std::fabs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

// A patch of the plane through `mean` with axes a and b, noise along a × b.
SomeCloud Patch(const Vector3& mean, const Vector3& a, const Vector3& b, double noise_m) {
  const Vector3 n = {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  SomeCloud cloud(31, 21);
  Rng rng(4);
  for (int v = 0; v < 21; ++v) {
    for (int u = 0; u < 31; ++u) {
      const double s = 0.004 * (u - 15);
      const double t = 0.003 * (v - 10);
      const double e = noise_m * rng.Normal();
      cloud.Set(u,
                v,
                {mean[0] + s * a[0] + t * b[0] + e * n[0],
                 mean[1] + s * a[1] + t * b[1] + e * n[1],
                 mean[2] + s * a[2] + t * b[2] + e * n[2]});
    }
  }
  return cloud;
}

const Vector3 kA = {0.6, 0.8, 0.0};
const Vector3 kB = {0.0, 0.0, 1.0};
const Vector3 kNormal = {0.8, -0.6, 0.0};

TEST(FitObjectPlane, OfThreePointsIsTheirPlane) {
  SomeCloud cloud(4, 2);
  cloud.Set(0, 0, {0, 0, 0.5});
  cloud.Set(3, 0, {1, 0, 0.5});
  cloud.Set(1, 1, {0, 2, 0.5});
  const ObjectPlane plane = cloud.Fit();
  EXPECT_EQ(plane.fault, CloudFault::kNone);
  EXPECT_EQ(plane.num_points, 3U);
  EXPECT_NEAR(plane.normal[2], 1.0, 1e-12);
  EXPECT_NEAR(plane.mean_m[0], 1.0 / 3.0, 1e-7);
  EXPECT_NEAR(plane.mean_m[1], 2.0 / 3.0, 1e-7);
  EXPECT_NEAR(plane.mean_m[2], 0.5, 1e-7);
}

TEST(FitObjectPlane, FindsThePlaneBehindNoise) {
  const Vector3 mean = {12.0, -3.0, 0.7};
  const ObjectPlane plane = Patch(mean, kA, kB, 0.001).Fit();
  EXPECT_EQ(plane.fault, CloudFault::kNone);
  // 651 points with 1 mm of noise over ±6 cm and ±3 cm: the normal is known to about 2 mrad.
  EXPECT_GT(AbsoluteDot(plane.normal, kNormal), std::cos(0.01));
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(plane.mean_m[axis], mean[axis], 1e-3);
}

TEST(FitObjectPlane, LooksAtTheMaskAndAtMeasuredPointsAlone) {
  SomeCloud cloud = Patch({0.1, 0.2, 0.3}, kA, kB, 0.001);
  const ObjectPlane whole = cloud.Fit();
  SomeCloud wider(40, 30);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (int v = 0; v < 21; ++v) {
    for (int u = 0; u < 31; ++u) {
      const float* p = cloud.points.data() + 3 * (v * 31 + u);
      wider.Set(u + 5, v + 4, {p[0], p[1], p[2]});
    }
  }
  for (int u = 0; u < 40; ++u) {
    wider.points[static_cast<std::size_t>(3 * u)] = 77.0F;  // outside the mask
    wider.Set(u, 29, {u % 2 == 0 ? nan : infinity, 0.0, 0.0});
  }
  const ObjectPlane same = wider.Fit();
  EXPECT_EQ(same.num_points, whole.num_points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(same.normal[axis], whole.normal[axis]);
    EXPECT_EQ(same.mean_m[axis], whole.mean_m[axis]);
  }
}

TEST(FitObjectPlane, TurnsWithTheCloud) {
  const double angle_rad = 0.7;
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  const auto turn = [&](const Vector3& p) {
    return Vector3{c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  };
  const ObjectPlane here = Patch({0.1, 0.2, 0.3}, kA, kB, 0.001).Fit();
  const ObjectPlane turned = Patch(turn({0.1, 0.2, 0.3}), turn(kA), turn(kB), 0.001).Fit();
  // The clouds are rounded to floats, and points at the fences may fall on the other side.
  EXPECT_NEAR(AbsoluteDot(turned.normal, turn(here.normal)), 1.0, 1e-5);
}

TEST(FitObjectPlane, PointsFarAwayDoNotCount) {
  SomeCloud cloud = Patch({0.1, 0.2, 0.3}, kA, kB, 0.001);
  const ObjectPlane clean = cloud.Fit();
  for (int v = 0; v < 4; ++v) cloud.Set(0, v, {3.0, 0.2, 0.3});
  const ObjectPlane plane = cloud.Fit();
  EXPECT_LE(plane.num_points, clean.num_points);
  EXPECT_GT(AbsoluteDot(plane.normal, clean.normal), std::cos(0.01));
}

TEST(FitObjectPlane, SaysWhyThereIsNone) {
  SomeCloud cloud(5, 5);
  EXPECT_EQ(cloud.Fit().fault, CloudFault::kTooFewPoints);
  cloud.Set(0, 0, {0, 0, 0});
  cloud.Set(2, 2, {1, 1, 1});
  EXPECT_EQ(cloud.Fit().fault, CloudFault::kTooFewPoints);
  cloud.Set(3, 2, {2, 2, 2});
  EXPECT_EQ(cloud.Fit().fault, CloudFault::kOnALine);
  SomeCloud one_place(5, 5);
  for (int u = 0; u < 5; ++u) one_place.Set(u, 0, {1, 2, 3});
  EXPECT_EQ(one_place.Fit().fault, CloudFault::kOnALine);
  SomeCloud ball(3, 2);  // an octahedron: as thick as it is wide
  ball.Set(0, 0, {1, 0, 0});
  ball.Set(1, 0, {-1, 0, 0});
  ball.Set(2, 0, {0, 1, 0});
  ball.Set(0, 1, {0, -1, 0});
  ball.Set(1, 1, {0, 0, 1});
  ball.Set(2, 1, {0, 0, -1});
  EXPECT_EQ(ball.Fit().fault, CloudFault::kNoSinglePlane);
}

TEST(NameOf, IsASentencesEnd) {
  EXPECT_EQ(NameOf(CloudFault::kTooFewPoints), "has fewer than three measured points");
  EXPECT_EQ(NameOf(CloudFault::kOnALine), "has its points on one line");
}

}  // namespace
}  // namespace handcraft::features
