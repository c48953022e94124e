// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/described_views.h"

#include <string>

#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

features::ViewDescription DescribeOne(const ViewSet& set, std::size_t index) {
  const LoadedView view = ReadView(set, index);
  if (!view.cloud) {
    throw Error({.path = (set.root / set.items[index].image).string(),
                 .reason = "the view has no cloud",
                 .remedy = "give a view set whose views.csv names one for each view"});
  }
  const features::ObjectCloud cloud = ObjectCloudOf(view);
  std::vector<float> scratch(features::ObjectPlaneScratch(cloud.width, cloud.height));
  features::ViewDescription description;
  const features::CloudFault fault = features::DescribeView(cloud, scratch, description);
  if (fault == features::CloudFault::kNone) return description;
  throw Error({.path = (set.root / set.items[index].cloud).string(),
               .reason = "the object's cloud " + std::string(features::NameOf(fault)),
               .remedy = "leave the view out, or look at it with 'handcraft data preview'"});
}

}  // namespace

features::ObjectCloud ObjectCloudOf(const LoadedView& view) {
  return {.points = view.cloud->points.data()->data(),
          .width = view.cloud->width,
          .height = view.cloud->height,
          .row_stride = std::ptrdiff_t{3} * view.cloud->width,
          .mask = view.object_mask.Row(0),
          .mask_stride = view.object_mask.width()};
}

std::vector<features::ViewDescription> DescribeViews(const ViewSet& set,
                                                     int num_threads,
                                                     const Progress& progress) {
  std::vector<features::ViewDescription> descriptions(set.items.size());
  ParallelForReporting(
      set.items.size(), num_threads, progress, "describing views", [&](std::size_t i) {
        descriptions[i] = DescribeOne(set, i);
      });
  return descriptions;
}

}  // namespace handcraft::datasets
