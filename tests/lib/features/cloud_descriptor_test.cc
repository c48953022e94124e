// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/cloud_descriptor.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lib/features/cell_normals.h"
#include "lib/features/shape_functions.h"
#include "lib/features/viewpoint_histogram.h"
#include "tests/lib/features/some_object.h"
#include "tests/support/allocation_counter.h"

namespace handcraft::features {
namespace {

using testing::SomeObject;

constexpr CloudDescriptorType kTypes[] = {
    CloudDescriptorType::kGrid, CloudDescriptorType::kDepthGrid, CloudDescriptorType::kPolar};
constexpr CloudDescriptorType kHistograms[] = {CloudDescriptorType::kViewpointHistogram,
                                               CloudDescriptorType::kShapeFunctions};
constexpr CloudDescriptorType kAllTypes[] = {CloudDescriptorType::kGrid,
                                             CloudDescriptorType::kDepthGrid,
                                             CloudDescriptorType::kPolar,
                                             CloudDescriptorType::kViewpointHistogram,
                                             CloudDescriptorType::kShapeFunctions};
static_assert(std::size(kAllTypes) == kNumCloudDescriptors);

std::vector<float> Describe(const CloudDescriptor& descriptor, const ObjectCloud& cloud) {
  std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
  std::vector<float> features(descriptor.NumFeatures(), 9.0F);
  EXPECT_TRUE(descriptor.Compute(cloud, workspace, features));
  return features;
}

double LargestDifference(const std::vector<float>& a, const std::vector<float>& b, double factor) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest,
                       std::fabs(factor * static_cast<double>(a[i]) - static_cast<double>(b[i])));
  }
  return largest;
}

TEST(CloudDescriptor, FourPointsByHand) {
  // A grid of 2 over 2 × 2 pixels, mean (2, 1, 0.5).
  const std::vector<float> points = {1, 0, 0, 3, 0, 0, 1, 2, 0, 3, 2, 2};
  const ObjectCloud cloud{.points = points.data(), .width = 2, .height = 2, .row_stride = 6};
  CloudDescriptor descriptor{.grid_size = 2};
  EXPECT_EQ(Describe(descriptor, cloud),
            (std::vector<float>{-1, -1, -0.5F, 1, -1, -0.5F, -1, 1, -0.5F, 1, 1, 1.5F}));
  // s² = (3 · 2.25 + 4.25) / 4 = 2.75
  descriptor.scaling = CloudScaling::kUnit;
  EXPECT_NEAR(Describe(descriptor, cloud)[11], 1.5 / std::sqrt(2.75), 1e-6);
  descriptor = {.type = CloudDescriptorType::kDepthGrid, .grid_size = 2};
  EXPECT_EQ(Describe(descriptor, cloud), (std::vector<float>{-1, 1, -1, 1}));
  descriptor.frame = CloudFrame::kCamera;
  EXPECT_EQ(Describe(descriptor, cloud), (std::vector<float>{-0.5F, -0.5F, -0.5F, 1.5F}));
}

TEST(CloudDescriptor, MovingThePointsChangesNothing) {
  const SomeObject object(61, 47);
  SomeObject moved = object;
  for (std::size_t i = 0; i < moved.points.size(); ++i) moved.points[i] += 0.5F;
  for (const CloudDescriptorType type : kTypes) {
    for (const CloudScaling scaling : {CloudScaling::kMetric, CloudScaling::kUnit}) {
      const CloudDescriptor descriptor{.type = type, .grid_size = 20, .scaling = scaling};
      // The coordinates' sums are exact; what is left is the rounding of a float of about 1.
      EXPECT_LT(LargestDifference(
                    Describe(descriptor, object.View()), Describe(descriptor, moved.View()), 1.0),
                4e-7);
    }
  }
}

TEST(CloudDescriptor, MovingTheObjectInThePictureChangesNothing) {
  const SomeObject object(40, 30);
  SomeObject large(90, 70);
  std::fill(large.mask.begin(), large.mask.end(), std::uint8_t{0});
  for (int v = 0; v < 30; ++v) {
    for (int u = 0; u < 40; ++u) {
      std::copy_n(
          object.View().Point(u, v), 3, large.points.begin() + ((v + 33) * 90 + u + 41) * 3);
      large.mask[static_cast<std::size_t>((v + 33) * 90 + u + 41)] =
          object.mask[static_cast<std::size_t>(v * 40 + u)];
    }
  }
  for (const CloudDescriptorType type : kTypes) {
    const CloudDescriptor descriptor{.type = type, .grid_size = 20};
    EXPECT_LT(LargestDifference(
                  Describe(descriptor, object.View()), Describe(descriptor, large.View()), 1.0),
              1e-7);
  }
}

// What is scale invariant: where points fall on the grid; not how far apart they are.
TEST(CloudDescriptor, PointsTwiceAsFarApartGiveTwiceTheMetricAndTheSameUnitFeatures) {
  const SomeObject object(61, 47);
  SomeObject grown = object;
  for (float& value : grown.points) value *= 2.0F;
  for (const CloudDescriptorType type : kTypes) {
    CloudDescriptor descriptor{.type = type, .grid_size = 20};
    EXPECT_EQ(LargestDifference(
                  Describe(descriptor, object.View()), Describe(descriptor, grown.View()), 2.0),
              0.0);
    descriptor.scaling = CloudScaling::kUnit;
    EXPECT_LT(LargestDifference(
                  Describe(descriptor, object.View()), Describe(descriptor, grown.View()), 1.0),
              1e-6);
  }
}

TEST(CloudDescriptor, EveryPixelThreeByThreeTimesGivesTheSameFeatures) {
  constexpr int kTimes = 3;
  const SomeObject object(60, 40);
  SomeObject near(60 * kTimes, 40 * kTimes);
  for (int v = 0; v < 40 * kTimes; ++v) {
    for (int u = 0; u < 60 * kTimes; ++u) {
      std::copy_n(object.View().Point(u / kTimes, v / kTimes),
                  3,
                  near.points.begin() + (v * 60 * kTimes + u) * 3);
    }
  }
  ObjectCloud small = object.View();
  ObjectCloud large = near.View();
  small.mask = nullptr;
  large.mask = nullptr;
  // No pixel lies across an edge of a cell.
  ASSERT_EQ(FindExtent(small).Width(), 60);
  ASSERT_EQ(FindExtent(small).Height(), 40);
  const CloudDescriptor descriptor{.grid_size = 20};
  EXPECT_LT(LargestDifference(Describe(descriptor, small), Describe(descriptor, large), 1.0), 1e-7);
}

TEST(CloudDescriptor, FewerThanThreePointsAreNoObject) {
  SomeObject object(20, 10);
  std::fill(object.points.begin(), object.points.end(), std::numeric_limits<float>::quiet_NaN());
  const CloudDescriptor descriptor{.grid_size = 5};
  std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
  std::vector<float> features(descriptor.NumFeatures());
  for (const std::size_t num_points : {0U, 1U, 2U, 3U}) {
    for (std::size_t k = 0; k < num_points; ++k) {
      std::fill_n(
          object.points.begin() + static_cast<std::ptrdiff_t>(3 * (5 * 20 + 8 + k)), 3, 1.0F);
    }
    std::fill(features.begin(), features.end(), 9.0F);
    EXPECT_EQ(descriptor.Compute(object.View(), workspace, features), num_points == 3);
    for (const float feature : features) EXPECT_EQ(feature, 0.0F);
  }
}

// The share of what two histograms of one kind do not have in common.
double Apart(const std::vector<float>& a, const std::vector<float>& b) {
  double difference = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference += std::fabs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    sum += static_cast<double>(a[i]) + static_cast<double>(b[i]);
  }
  return difference / sum;
}

TEST(CloudDescriptor, HistogramsAreThoseOfTheCellsMeanPoints) {
  const SomeObject object(61, 47);
  CloudDescriptor descriptor{.grid_size = 12, .frame = CloudFrame::kCamera};
  std::vector<CellSum> sums(12 * 12);
  ASSERT_GT(SumCells(object.View(), 12, GridBox::kFitted, sums), 0U);
  std::vector<Vector3> points;
  for (const CellSum& sum : sums) {
    if (sum.count > 0.0) {
      points.push_back({sum.x / sum.count, sum.y / sum.count, sum.z / sum.count});
    }
  }
  std::vector<std::byte> workspace(ShapeFunctionsWorkspace(points.size()));
  std::vector<float> shape(kShapeFunctionsSize);
  DescribeByShapeFunctions(points, workspace, std::span<float, kShapeFunctionsSize>(shape));
  descriptor.type = CloudDescriptorType::kShapeFunctions;
  EXPECT_LT(Apart(Describe(descriptor, object.View()), shape), 0.01);

  std::vector<SurfacePoint> surface(sums.size());
  surface.resize(FindCellNormals(sums, 12, {}, {}, surface));
  std::vector<float> view(kViewpointHistogramSize);
  DescribeByViewpointHistogram(surface, {}, std::span<float, kViewpointHistogramSize>(view));
  descriptor.type = CloudDescriptorType::kViewpointHistogram;
  EXPECT_LT(Apart(Describe(descriptor, object.View()), view), 0.01);
}

TEST(CloudDescriptor, HistogramsOfPointsTwiceAsFarApartAndAwayAreTheSame) {
  const SomeObject object(61, 47);
  SomeObject grown = object;
  for (float& value : grown.points) value *= 2.0F;
  for (const CloudDescriptorType type : kHistograms) {
    const CloudDescriptor descriptor{.type = type, .grid_size = 20, .frame = CloudFrame::kCamera};
    EXPECT_EQ(Describe(descriptor, object.View()), Describe(descriptor, grown.View()));
  }
}

TEST(CloudDescriptor, ShapeFunctionsOfMovedPointsAreTheSameAndTheViewIsNot) {
  const SomeObject object(61, 47);
  SomeObject moved = object;
  for (std::size_t i = 2; i < moved.points.size(); i += 3) moved.points[i] += 2.0F;
  CloudDescriptor descriptor{.type = CloudDescriptorType::kShapeFunctions, .grid_size = 20};
  EXPECT_LT(Apart(Describe(descriptor, object.View()), Describe(descriptor, moved.View())), 0.01);
  descriptor.type = CloudDescriptorType::kViewpointHistogram;
  EXPECT_GT(Apart(Describe(descriptor, object.View()), Describe(descriptor, moved.View())), 0.05);
}

TEST(CloudDescriptor, OfTheViewNeedsTheCamerasFrame) {
  for (const CloudDescriptorType type : kAllTypes) {
    EXPECT_EQ((CloudDescriptor{.type = type}.FrameFits()),
              type != CloudDescriptorType::kViewpointHistogram);
    EXPECT_TRUE((CloudDescriptor{.type = type, .frame = CloudFrame::kCamera}.FrameFits()));
  }
}

TEST(CloudDescriptor, NeverWritesWhatIsNotFinite) {
  constexpr float kMax = std::numeric_limits<float>::max();
  SomeObject object(24, 24);
  for (std::size_t i = 0; i < object.points.size(); i += 7) object.points[i] = kMax;
  for (std::size_t i = 3; i < object.points.size(); i += 11) object.points[i] = -1e6F;
  for (const CloudDescriptorType type : kAllTypes) {
    for (const CloudScaling scaling : {CloudScaling::kMetric, CloudScaling::kUnit}) {
      for (const int side : {1, 5, 128}) {
        for (const float feature : Describe({type, side, scaling}, object.View())) {
          ASSERT_TRUE(std::isfinite(feature));
        }
      }
    }
  }
}

TEST(CloudDescriptor, OfPointsInOnePlaceIsZero) {
  SomeObject object(10, 10);
  std::fill(object.points.begin(), object.points.end(), 0.25F);
  for (const CloudScaling scaling : {CloudScaling::kMetric, CloudScaling::kUnit}) {
    for (const CloudDescriptorType type : kAllTypes) {
      const CloudDescriptor descriptor{.type = type, .grid_size = 5, .scaling = scaling};
      for (const float feature : Describe(descriptor, object.View())) EXPECT_EQ(feature, 0.0F);
    }
  }
}

TEST(CloudDescriptor, DoesNotAllocate) {
  if (!testing::AllocationCounter::Available()) GTEST_SKIP() << "a sanitizer has its own malloc";
  const SomeObject object(40, 30);
  for (const CloudDescriptorType type : kAllTypes) {
    const CloudDescriptor descriptor{.type = type};
    std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
    std::vector<float> features(descriptor.NumFeatures());
    const testing::AllocationCounter counter;
    const bool done = descriptor.Compute(object.View(), workspace, features);
    EXPECT_EQ(counter.Count(), 0U);
    EXPECT_TRUE(done);
  }
}

TEST(CloudDescriptor, Names) {
  EXPECT_EQ(NameOf(CloudDescriptorType::kGrid), "grid");
  EXPECT_EQ(NameOf(CloudDescriptorType::kDepthGrid), "depth-grid");
  EXPECT_EQ(NameOf(CloudDescriptorType::kPolar), "polar");
  EXPECT_EQ(NameOf(CloudDescriptorType::kViewpointHistogram), "vfh");
  EXPECT_EQ(NameOf(CloudDescriptorType::kShapeFunctions), "esf");
  EXPECT_EQ(NameOf(GridBox::kSquare), "square");
  EXPECT_EQ(NameOf(CloudScaling::kUnit), "unit");
  EXPECT_EQ(NameOf(CloudFrame::kCamera), "camera");
}

}  // namespace
}  // namespace handcraft::features
