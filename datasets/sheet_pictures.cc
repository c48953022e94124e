// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/sheet_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"
#include "lib/perception/overlay.h"

namespace handcraft::datasets {
namespace {

Image InColour(const Image& image) {
  return perception::DrawLabelMask(image, Image(image.width(), image.height()));
}

std::string CaptionOf(const std::string& image) {
  return std::filesystem::path(image).stem().string();
}

// Depth of each point along the optical axis [m]; NaN where there is none.
std::vector<float> DepthsOf(const OrganisedCloud& cloud) {
  const Eigen::Isometry3f camera_from_base = cloud.base_from_camera.inverse();
  std::vector<float> depths;
  depths.reserve(cloud.points.size());
  for (const Eigen::Vector3f& p_in_base : cloud.points)
    depths.push_back((camera_from_base * p_in_base).z());
  return depths;
}

struct Range {
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = -std::numeric_limits<float>::infinity();

  [[nodiscard]] bool IsEmpty() const { return nearest > farthest; }
};

// Of the points on the object, or of all.
Range RangeOf(const std::vector<float>& depths, const Image* object_mask) {
  Range range;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (std::isnan(depths[i])) continue;
    if (object_mask != nullptr && object_mask->values()[i] != kObject) continue;
    range.nearest = std::min(range.nearest, depths[i]);
    range.farthest = std::max(range.farthest, depths[i]);
  }
  return range;
}

}  // namespace

std::vector<SheetPicture> SheetPicturesOf(const LabelledImageSet& set) {
  std::vector<SheetPicture> pictures;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const LabelledImage& item = set.items[i];
    pictures.push_back({.row = item.object_class,
                        .split = item.split,
                        .caption = CaptionOf(item.image),
                        .draw = [&set, i] {
                          const LabelledPicture picture = ReadLabelledPicture(set, i);
                          return std::vector<Image>{
                              InColour(picture.image),
                              perception::DrawLabelMask(picture.image, picture.mask)};
                        }});
  }
  return pictures;
}

std::vector<SheetPicture> SheetPicturesOf(const ViewSet& set) {
  std::vector<SheetPicture> pictures;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const ObjectView& item = set.items[i];
    pictures.push_back({.row = item.object_class,
                        .split = item.split,
                        .caption = CaptionOf(item.image),
                        .draw = [&set, i] {
                          const LoadedView view = ReadView(set, i);
                          return std::vector<Image>{
                              InColour(view.image),
                              view.cloud ? DrawDepths(*view.cloud, view.object_mask)
                                         : Image(view.image.width(), view.image.height(), 3),
                              perception::DrawLabelMask(view.image, view.object_mask)};
                        }});
  }
  return pictures;
}

Image DrawDepths(const OrganisedCloud& cloud, const Image& object_mask) {
  HC_CHECK(cloud.width == object_mask.width() && cloud.height == object_mask.height(),
           cloud.width,
           object_mask.width());
  const std::vector<float> depths = DepthsOf(cloud);
  Range range = RangeOf(depths, &object_mask);
  if (range.IsEmpty()) range = RangeOf(depths, nullptr);
  Image drawn(cloud.width, cloud.height, 3);
  if (range.IsEmpty()) return drawn;
  const float span_m = std::max(range.farthest - range.nearest, 1e-6F);
  cv::Mat levels(cloud.height, cloud.width, CV_8U, cv::Scalar(0));
  cv::Mat is_measured(cloud.height, cloud.width, CV_8U, cv::Scalar(0));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (std::isnan(depths[i])) continue;
    const float nearness = std::clamp((range.farthest - depths[i]) / span_m, 0.0F, 1.0F);
    levels.data[i] = static_cast<std::uint8_t>(std::lround(255.0F * nearness));
    is_measured.data[i] = 255;
  }
  cv::Mat colours;
  cv::applyColorMap(levels, colours, cv::COLORMAP_TURBO);
  cv::Mat pixels(drawn.height(), drawn.width(), CV_8UC3, drawn.Row(0));
  colours.copyTo(pixels, is_measured);
  return drawn;
}

}  // namespace handcraft::datasets
