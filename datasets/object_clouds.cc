// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/object_clouds.h"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "datasets/formats/listing_rules.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/features/mask_pixels.h"
#include "lib/perception/cloud_outliers.h"

namespace handcraft::datasets {
namespace {

constexpr std::uint8_t kInside = 255;

// Leaves in the mask what is no outlier of the points under it.
void KeepInliers(const OrganisedCloud& cloud, double step, Image& mask) {
  if (step == 0.0) return;
  perception::PixelPoints points;
  points.Reset(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (mask.values()[i] == 0 || !IsMeasured(cloud.points[i])) continue;
    points.Add(cloud.points[i], static_cast<std::int32_t>(i));
  }
  perception::RemoveOutliers(points, {.step = static_cast<float>(step)});
  Image kept(mask.width(), mask.height());
  for (const std::int32_t pixel : points.Pixels()) kept.Row(0)[pixel] = kInside;
  mask = std::move(kept);
}

}  // namespace

void ObjectCloudOptions::Validate() const {
  RequireOption(outlier_step >= 0.0 && outlier_step <= 100.0,
                "ObjectCloudOptions.outlier_step",
                outlier_step,
                "from 0 to 100");
}

features::ObjectCloud MaskedCloud::View() const noexcept {
  return {.points = cloud.points.empty() ? nullptr : cloud.points.front().data(),
          .width = cloud.width,
          .height = cloud.height,
          .row_stride = std::ptrdiff_t{3} * cloud.width,
          .point_stride = 3,
          .mask = mask.Row(0),
          .mask_stride = mask.width()};
}

MaskedCloud CropToMask(const OrganisedCloud& cloud, const Image& mask) {
  int u_begin = mask.width();
  int u_end = 0;
  int v_begin = mask.height();
  int v_end = 0;
  features::ForEachMaskRun(
      {mask.Row(0), mask.width()}, mask.width(), mask.height(), [&](int v, int first, int last) {
        u_begin = std::min(u_begin, first);
        u_end = std::max(u_end, last);
        v_begin = std::min(v_begin, v);
        v_end = v + 1;
      });
  MaskedCloud cropped{.cloud = {}, .mask = {}};
  cropped.cloud.base_from_camera = cloud.base_from_camera;
  if (v_end == 0) return cropped;
  cropped.cloud.width = u_end - u_begin;
  cropped.cloud.height = v_end - v_begin;
  cropped.mask = Image(cropped.cloud.width, cropped.cloud.height);
  for (int v = v_begin; v < v_end; ++v) {
    const auto row = cloud.points.begin() + std::ptrdiff_t{v} * cloud.width;
    cropped.cloud.points.insert(cropped.cloud.points.end(), row + u_begin, row + u_end);
    std::copy_n(mask.Row(v) + u_begin, cropped.cloud.width, cropped.mask.Row(v - v_begin));
  }
  return cropped;
}

MaskedCloud ReadObjectCloud(const ViewSet& set,
                            std::size_t index,
                            const ObjectCloudOptions& options) {
  options.Validate();
  const ObjectView& item = set.items.at(index);
  if (item.cloud.empty()) {
    throw Error({.path = (set.root / kViewsFileName).string(),
                 .reason = "the view " + item.image + " has no cloud",
                 .remedy = "give views with clouds"});
  }
  MaskedCloud object{.cloud = ReadPcd(set.root / item.cloud), .mask = ReadObjectMask(set, index)};
  RequireSameSize(
      set.root / item.object_mask, "the mask", SizeOf(object.mask), SizeOf(object.cloud));
  return TakeObjectCloud(std::move(object.cloud), std::move(object.mask), options);
}

MaskedCloud TakeObjectCloud(OrganisedCloud cloud, Image mask, const ObjectCloudOptions& options) {
  options.Validate();
  MaskedCloud object{.cloud = std::move(cloud), .mask = std::move(mask)};
  KeepInliers(object.cloud, options.outlier_step, object.mask);
  ChangeFrame(options.frame, object.cloud);
  return object;
}

MaskedCloud FindObjectCloud(OrganisedCloud cloud,
                            const perception::TableRemovalOptions& table,
                            const ObjectCloudOptions& options) {
  options.Validate();
  const perception::TablePlanes planes = perception::FindTable(cloud.View(), table);
  perception::PixelPoints points;
  perception::TakePointsOffPlanes(cloud.View(), planes.planes, table.epsilon_m, points);
  Image mask(cloud.width, cloud.height);
  for (const std::int32_t pixel : points.Pixels()) mask.Row(0)[pixel] = kInside;
  return TakeObjectCloud(std::move(cloud), std::move(mask), options);
}

void ChangeFrame(features::CloudFrame frame, OrganisedCloud& cloud) {
  if (frame == features::CloudFrame::kBase) return;
  const Eigen::Isometry3f camera_from_base = cloud.base_from_camera.inverse();
  for (Eigen::Vector3f& point : cloud.points) point = camera_from_base * point;
}

void DescribeObject(const MaskedCloud& object,
                    const features::CloudDescriptor& descriptor,
                    std::span<float> row) {
  std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
  if (descriptor.Compute(object.View(), workspace, row)) return;
  throw Error({.reason = fmt::format("fewer than {} points of the object were measured",
                                     features::kMinObjectPoints),
               .remedy = "leave the view out"});
}

void NamingCloud(const ViewSet& set, std::size_t index, const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    Error::Details details = error.details();
    if (details.path.empty()) details.path = (set.root / set.items[index].cloud).string();
    throw Error(std::move(details));
  }
}

CloudFeatures DescribeViews(const ViewSet& set,
                            const features::CloudDescriptor& descriptor,
                            const ObjectCloudOptions& options,
                            int num_threads,
                            const Progress& progress) {
  CloudFeatures features{.values = std::vector<float>(set.items.size() * descriptor.NumFeatures()),
                         .num_views = set.items.size(),
                         .num_features = descriptor.NumFeatures()};
  ParallelForReporting(
      set.items.size(), num_threads, progress, "describing clouds", [&](std::size_t i) {
        const MaskedCloud object = ReadObjectCloud(set, i, options);
        const auto row =
            std::span(features.values).subspan(i * features.num_features, features.num_features);
        NamingCloud(set, i, [&] { DescribeObject(object, descriptor, row); });
      });
  return features;
}

}  // namespace handcraft::datasets
