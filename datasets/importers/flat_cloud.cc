// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/flat_cloud.h"

#include <cstdint>

#include "datasets/importers/depth_cloud.h"

namespace handcraft::datasets {
namespace {

// Right is the base's −y, down its −z, forward its x.
Eigen::Isometry3d BaseFromCamera() {
  Eigen::Isometry3d base_from_camera = Eigen::Isometry3d::Identity();
  base_from_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return base_from_camera;
}

}  // namespace

OrganisedCloud FlatCloudOf(const Image& mask) {
  constexpr double kMillimetre_m = 0.001;
  constexpr auto kAhead_mm = static_cast<std::uint16_t>(kFlatDepth_m / kMillimetre_m);
  BasicImage<std::uint16_t> depth(mask.width(), mask.height());
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) depth.At(u, v) = mask.At(u, v) != 0 ? kAhead_mm : 0;
  }
  const Pinhole camera{.fx_px = kFlatFocal_px,
                       .fy_px = kFlatFocal_px,
                       .cx_px = 0.5 * (mask.width() - 1),
                       .cy_px = 0.5 * (mask.height() - 1)};
  return CloudOfDepth(depth, kMillimetre_m, camera, BaseFromCamera());
}

void AddFlatClouds(SourceSet& source) {
  for (SourcePicture& picture : source.pictures) {
    if (picture.make_cloud) continue;
    picture.make_cloud = [make_mask = picture.make_mask](int width, int height) {
      return FlatCloudOf(make_mask(width, height));
    };
  }
}

}  // namespace handcraft::datasets
