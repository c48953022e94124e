// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/plane_fit.h"

#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::perception {
namespace {

std::optional<Plane> Fit(const std::vector<Eigen::Vector3f>& points) {
  PlaneFit fit;
  for (const Eigen::Vector3f& point : points) fit.Add(point);
  return fit.Solve();
}

Eigen::Vector3f RandomDirection(Rng& rng) {
  Eigen::Vector3f direction;
  for (float& x : direction) x = static_cast<float>(rng.Normal());
  return direction.normalized();
}

// Points of a plane, with noise along its normal.
std::vector<Eigen::Vector3f> NoisyPlane(const Plane& plane, float noise_m, Rng& rng) {
  const Eigen::Vector3f first = plane.normal.unitOrthogonal();
  const Eigen::Vector3f second = plane.normal.cross(first);
  std::vector<Eigen::Vector3f> points;
  points.reserve(200);
  for (int i = 0; i < 200; ++i) {
    points.emplace_back((plane.offset_m + noise_m * static_cast<float>(rng.Normal())) *
                            plane.normal +
                        0.1F * static_cast<float>(rng.Normal()) * first +
                        0.05F * static_cast<float>(rng.Normal()) * second);
  }
  return points;
}

TEST(PlaneFit, FindsThePlaneOfThreePoints) {
  const auto plane = Fit({{1, 0, 2}, {0, 1, 2}, {-1, -1, 2}});
  ASSERT_TRUE(plane);
  const Plane turned = plane->TurnedTo({0, 0, 5});
  EXPECT_NEAR(turned.normal.z(), 1.0F, 1e-6F);
  EXPECT_NEAR(turned.offset_m, 2.0F, 1e-6F);
  EXPECT_NEAR(turned.Distance({7, 8, 3}), 1.0F, 1e-5F);
  EXPECT_NEAR(plane->TurnedTo({0, 0, -1}).Distance({7, 8, 3}), -1.0F, 1e-5F);
}

// Four points above and below a plane: by hand, Σ distance² is least for z = 0.
TEST(PlaneFit, MinimisesOrthogonalDistances) {
  const auto plane = Fit({{1, 0, 0.1F}, {-1, 0, 0.1F}, {0, 1, -0.1F}, {0, -1, -0.1F}});
  ASSERT_TRUE(plane);
  EXPECT_NEAR(std::abs(plane->normal.z()), 1.0F, 1e-6F);
  EXPECT_NEAR(plane->offset_m, 0.0F, 1e-6F);
}

// The right singular vector of the least singular value, by Eigen's two-sided Jacobi iteration.
TEST(PlaneFit, AgreesWithTheSingularValueDecomposition) {
  Rng rng = Rng::Stream(1, "plane_fit");
  for (int i = 0; i < 100; ++i) {
    const Plane truth{RandomDirection(rng), static_cast<float>(rng.Uniform())};
    const auto points = NoisyPlane(truth, 0.005F, rng);
    const auto plane = Fit(points);
    ASSERT_TRUE(plane);
    Eigen::MatrixXd centred(points.size(), 3);
    for (std::size_t k = 0; k < points.size(); ++k) {
      centred.row(static_cast<Eigen::Index>(k)) = points[k].cast<double>();
    }
    const Eigen::RowVector3d mean = centred.colwise().mean();
    centred.rowwise() -= mean;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(centred, Eigen::ComputeThinV);
    const Eigen::Vector3d normal = svd.matrixV().col(2);
    EXPECT_LT(normal.cross(plane->normal.cast<double>()).norm(), 3e-7) << "single precision";
    EXPECT_NEAR(plane->Distance(mean.transpose().cast<float>()), 0.0F, 1e-6F);
    EXPECT_GT(std::abs(truth.normal.dot(plane->normal)), 0.999F);
  }
}

TEST(PlaneFit, LosesNothingFarFromTheOrigin) {
  Rng rng = Rng::Stream(1, "far");
  const Plane truth{Eigen::Vector3f(0.6F, 0.0F, 0.8F), 1000.0F};
  const auto plane = Fit(NoisyPlane(truth, 0.0F, rng));
  ASSERT_TRUE(plane);
  EXPECT_GT(std::abs(truth.normal.dot(plane->normal)), 0.9999F) << "coordinates have 6e-5 m";
}

TEST(PlaneFit, HasNoPlaneForFewerThanThreePoints) {
  EXPECT_FALSE(PlaneFit().Solve());
  EXPECT_FALSE(Fit({{1, 2, 3}}));
  EXPECT_FALSE(Fit({{1, 2, 3}, {4, 5, 6}}));
}

TEST(PlaneFit, HasNoPlaneForPointsOnALineOrInOnePlace) {
  EXPECT_FALSE(Fit({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {-3, -6, -9}}));
  EXPECT_FALSE(Fit(std::vector<Eigen::Vector3f>(9, Eigen::Vector3f(1, 2, 3))));
}

TEST(PlaneFit, HasNoPlaneForNaN) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(Fit({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}}));
}

}  // namespace
}  // namespace handcraft::perception
