// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/object_clouds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/synthetic/view_sets.h"
#include "lib/core/error.h"
#include "tests/datasets/small_view_set.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::size_t NumObjectPixels(const Image& mask) {
  return static_cast<std::size_t>(
      std::count(mask.values().begin(), mask.values().end(), std::uint8_t{255}));
}

std::vector<float> Describe(const MaskedCloud& object,
                            const features::CloudDescriptor& descriptor) {
  std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
  std::vector<float> features(descriptor.NumFeatures());
  EXPECT_TRUE(descriptor.Compute(object.View(), workspace, features));
  return features;
}

double Length(std::span<const float> values) {
  double squares = 0.0;
  for (const float value : values)
    squares += static_cast<double>(value) * static_cast<double>(value);
  return std::sqrt(squares);
}

double Distance(std::span<const float> a, std::span<const float> b) {
  std::vector<float> difference(a.begin(), a.end());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] -= b[i];
  return Length(difference);
}

// A mug measured by a noisy camera, rendered once.
class MeasuredMug : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    synthetic::ViewSetOptions options;
    options.num_views = 1;
    options.sensor = synthetic::CloudSensor::kDepthCamera;
    options.camera = {.width_px = 160,
                      .height_px = 120,
                      .focal_px = 131.25F,
                      .centre_u_px = 79.5F,
                      .centre_v_px = 59.5F};
    folder_ = std::make_unique<TemporaryDirectory>();
    set_ = synthetic::MakeViewSet(*folder_ / "set", options).set;
    set_.items = {set_.items[3]};
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::unique_ptr<TemporaryDirectory> folder_;
  static ViewSet set_;
};
std::unique_ptr<TemporaryDirectory> MeasuredMug::folder_;
ViewSet MeasuredMug::set_;

TEST(ObjectClouds, ThePointsUnderTheMask) {
  const TemporaryDirectory folder;
  const ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  const MaskedCloud object = ReadObjectCloud(set, 0, {.outlier_step = 0.0});
  EXPECT_EQ(NumObjectPixels(object.mask), 24U);
  EXPECT_EQ(object.cloud.points, handcraft::testing::FlatCloud(8, 6).points);
  EXPECT_TRUE(object.View().Has(3, 5));
  EXPECT_FALSE(object.View().Has(4, 5));
}

TEST(ObjectClouds, OutliersGo) {
  const TemporaryDirectory folder;
  const ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  OrganisedCloud cloud = handcraft::testing::FlatCloud(8, 6);
  cloud.points[9] = {0.01F, 40.0F, 0.0F};
  WritePcd(folder / "a.pcd", cloud);
  const MaskedCloud object = ReadObjectCloud(set, 0);
  EXPECT_EQ(NumObjectPixels(object.mask), 23U);
  EXPECT_FALSE(object.View().Has(1, 1));
}

TEST(ObjectClouds, InTheCamerasFrame) {
  const TemporaryDirectory folder;
  const ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  OrganisedCloud cloud = handcraft::testing::FlatCloud(8, 6);
  cloud.base_from_camera.translation() = Eigen::Vector3f(1.0F, 2.0F, 4.0F);
  WritePcd(folder / "a.pcd", cloud);
  const MaskedCloud object = ReadObjectCloud(set, 0, {.frame = features::CloudFrame::kCamera});
  EXPECT_TRUE(object.cloud.At(0, 0).isApprox(Eigen::Vector3f(-1.0F, -2.0F, -4.0F), 1e-6F));
}

TEST(ObjectClouds, DescribesEachViewOnAnyNumberOfThreads) {
  const TemporaryDirectory folder;
  ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  set.items.erase(set.items.begin() + 1);
  const features::CloudDescriptor descriptor{.grid_size = 3};
  const CloudFeatures one = DescribeViews(set, descriptor);
  EXPECT_EQ(one.num_views, 2U);
  EXPECT_EQ(one.Matrix().num_features, 27U);
  EXPECT_EQ(DescribeViews(set, descriptor, {}, 2).values, one.values);
}

TEST(ObjectClouds, AViewWithoutACloudIsNamed) {
  const TemporaryDirectory folder;
  const ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  EXPECT_THROWS_MESSAGE(static_cast<void>(DescribeViews(set, {})),
                        Error,
                        AllOf(HasSubstr("views.csv"), HasSubstr("b.png has no cloud")));
}

TEST(ObjectClouds, ACloudOfTwoPointsIsNamed) {
  const TemporaryDirectory folder;
  ViewSet set = handcraft::testing::MakeViewSet(folder.path());
  OrganisedCloud cloud = handcraft::testing::FlatCloud(8, 6);
  for (std::size_t i = 2; i < cloud.points.size(); ++i) {
    cloud.points[i].setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  WritePcd(folder / "a.pcd", cloud);
  set.items.resize(1);
  EXPECT_THROWS_MESSAGE(static_cast<void>(DescribeViews(set, {})),
                        Error,
                        AllOf(HasSubstr("a.pcd"), HasSubstr("fewer than 3 points")));
}

TEST(ObjectClouds, OptionsAreChecked) {
  EXPECT_THROWS_MESSAGE((ObjectCloudOptions{.outlier_step = -1.0}).Validate(),
                        Error,
                        HasSubstr("ObjectCloudOptions.outlier_step"));
}

TEST_F(MeasuredMug, IsFoundOnTheTableWithoutItsMask) {
  const MaskedCloud masked = ReadObjectCloud(set_, 0);
  const MaskedCloud found = FindObjectCloud(ReadPcd(set_.root / set_.items[0].cloud), {});
  std::size_t in_both = 0;
  for (std::size_t i = 0; i < masked.mask.values().size(); ++i) {
    in_both += masked.mask.values()[i] == 255 && found.mask.values()[i] == 255 ? 1 : 0;
  }
  // What is below and behind the table is found as well.
  EXPECT_GT(in_both, NumObjectPixels(masked.mask) * 8 / 10);
  EXPECT_LT(NumObjectPixels(found.mask), 160U * 120U / 20);
}

// The laws of features::CloudDescriptor on a measured cloud.
TEST_F(MeasuredMug, DescriptorIsInvariantToTranslation) {
  const MaskedCloud object = ReadObjectCloud(set_, 0);
  MaskedCloud moved = object;
  for (Eigen::Vector3f& point : moved.cloud.points) point += Eigen::Vector3f(0.3F, -0.2F, 0.1F);
  const features::CloudDescriptor descriptor{.grid_size = 20};
  const std::vector<float> features = Describe(object, descriptor);
  EXPECT_LT(Distance(Describe(moved, descriptor), features), 1e-5 * Length(features));
}

TEST_F(MeasuredMug, UnitFeaturesAreInvariantToScaleAndMetricOnesAreNot) {
  const MaskedCloud object = ReadObjectCloud(set_, 0);
  MaskedCloud grown = object;
  for (Eigen::Vector3f& point : grown.cloud.points) point *= 1.3F;
  const features::CloudDescriptor metric{.grid_size = 20};
  features::CloudDescriptor unit = metric;
  unit.scaling = features::CloudScaling::kUnit;
  const std::vector<float> features = Describe(object, metric);
  EXPECT_NEAR(Distance(Describe(grown, metric), features) / Length(features), 0.3, 1e-4);
  EXPECT_LT(Distance(Describe(grown, unit), Describe(object, unit)),
            1e-4 * Length(Describe(object, unit)));
}

TEST(CropToMask, KeepsWhatTheMaskHolds) {
  OrganisedCloud cloud;
  cloud.width = 12;
  cloud.height = 5;
  for (int i = 0; i < 60; ++i) cloud.points.emplace_back(static_cast<float>(i), 0.0F, 1.0F);
  Image mask(12, 5);
  mask.At(9, 1) = 255;
  mask.At(3, 2) = 255;
  const MaskedCloud cropped = CropToMask(cloud, mask);
  ASSERT_EQ(cropped.cloud.width, 7);
  ASSERT_EQ(cropped.cloud.height, 2);
  EXPECT_EQ(cropped.cloud.At(6, 0).x(), 21.0F);
  EXPECT_EQ(cropped.cloud.At(0, 1).x(), 27.0F);
  EXPECT_EQ(cropped.mask.At(6, 0), 255);
  EXPECT_EQ(cropped.mask.At(0, 0), 0);
  EXPECT_TRUE(CropToMask(cloud, Image(12, 5)).cloud.points.empty());
}

}  // namespace
}  // namespace handcraft::datasets
