// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/pcl_table_peer.h"

#include "lib/core/check.h"

#ifdef HANDCRAFT_HAS_PCL

#include <pcl/ModelCoefficients.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/filter.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/sac_segmentation.h>

namespace handcraft::experiments {

struct PclTablePeer::Cloud {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points{new pcl::PointCloud<pcl::PointXYZ>};
};

bool PclTablePeer::IsAvailable() noexcept { return true; }

PclTablePeer::PclTablePeer(const perception::CloudView& cloud) : cloud_(new Cloud) {
  cloud_->points->width = static_cast<std::uint32_t>(cloud.width);
  cloud_->points->height = static_cast<std::uint32_t>(cloud.height);
  cloud_->points->is_dense = false;
  for (const Eigen::Vector3f& point : cloud.points) {
    cloud_->points->points.emplace_back(point.x(), point.y(), point.z());
  }
}

PclTablePeer::~PclTablePeer() = default;

std::vector<std::int32_t> PclTablePeer::PixelsOffTable(
    const perception::TableRemovalOptions& options) const {
  const pcl::PointCloud<pcl::PointXYZ>::Ptr measured(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::Indices pixels;
  pcl::removeNaNFromPointCloud(*cloud_->points, *measured, pixels);
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients(true);
  segmentation.setModelType(pcl::SACMODEL_PERPENDICULAR_PLANE);
  segmentation.setMethodType(pcl::SAC_RANSAC);
  segmentation.setAxis(options.up.normalized());
  segmentation.setEpsAngle(static_cast<double>(options.max_angle_rad));
  segmentation.setDistanceThreshold(static_cast<double>(options.epsilon_m));
  segmentation.setInputCloud(measured);
  const pcl::PointIndices::Ptr inliers(new pcl::PointIndices);
  pcl::ModelCoefficients coefficients;
  segmentation.segment(*inliers, coefficients);
  pcl::ExtractIndices<pcl::PointXYZ> extract;
  extract.setInputCloud(measured);
  extract.setIndices(inliers);
  extract.setNegative(true);
  pcl::Indices rest;
  extract.filter(rest);
  std::vector<std::int32_t> off_table;
  off_table.reserve(rest.size());
  for (const auto i : rest) off_table.push_back(pixels[static_cast<std::size_t>(i)]);
  return off_table;
}

}  // namespace handcraft::experiments

#else

namespace handcraft::experiments {

struct PclTablePeer::Cloud {};

bool PclTablePeer::IsAvailable() noexcept { return false; }

PclTablePeer::PclTablePeer(const perception::CloudView& /*cloud*/) {
  HC_CHECK(IsAvailable(), "configure with -DHANDCRAFT_PCL_PEER=ON");
}

PclTablePeer::~PclTablePeer() = default;

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): never reached without PCL.
std::vector<std::int32_t> PclTablePeer::PixelsOffTable(
    const perception::TableRemovalOptions& /*options*/) const {
  return {};
}

}  // namespace handcraft::experiments

#endif
