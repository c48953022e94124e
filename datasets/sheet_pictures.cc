// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/sheet_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "datasets/close_up.h"
#include "datasets/formats/mask_picture.h"
#include "lib/core/check.h"
#include "lib/perception/overlay.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using perception::PixelBox;

Image InColour(const Image& image) {
  return perception::DrawLabelMask(image, Image(image.width(), image.height()));
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

// All of a picture where there is nothing to go near to.
PixelBox CloseUpOrAll(const std::optional<PixelBox>& object, const Image& image) {
  if (!object) return {.u_px = 0, .v_px = 0, .width = image.width(), .height = image.height()};
  return CloseUpOf(*object, image.width(), image.height());
}

// The box of what a labelled picture shows.
std::optional<PixelBox> ObjectBox(const LabelledImageSet& set,
                                  std::size_t index,
                                  const LabelledPicture& picture) {
  const std::string object_mask = set.items[index].Companion(kObjectMask);
  if (object_mask.empty()) return FindBox(picture.mask, kMaskGood);
  const fs::path path = set.root / object_mask;
  const Image object = ReadObjectMask(path);
  RequireSameSize(path, "the object_mask", SizeOf(object), SizeOf(picture.image));
  return FindBox(object, kObject);
}

std::vector<Image> DrawPicture(const LabelledImageSet& set, std::size_t index, Framing framing) {
  const LabelledPicture picture = ReadLabelledPicture(set, index);
  if (framing == Framing::kWhole) {
    return {InColour(picture.image), perception::DrawLabelMask(picture.image, picture.mask)};
  }
  const PixelBox box = CloseUpOrAll(ObjectBox(set, index, picture), picture.image);
  const Image part = CutOut(picture.image, box);
  return {InColour(picture.image),
          InColour(part),
          perception::DrawLabelMask(part, CutOut(picture.mask, box))};
}

std::vector<Image> DrawView(const ViewSet& set, std::size_t index, Framing framing) {
  const LoadedView view = ReadView(set, index);
  const Image depths = view.cloud ? DrawDepths(*view.cloud, view.object_mask)
                                  : Image(view.image.width(), view.image.height(), 3);
  const PixelBox box = CloseUpOrAll(
      framing == Framing::kWhole ? std::nullopt : FindBox(view.object_mask, kObject), view.image);
  return {InColour(view.image),
          CutOut(depths, box),
          perception::DrawLabelMask(CutOut(view.image, box), CutOut(view.object_mask, box))};
}

// `draw` draws the picture of a number in a framing.
template <class Set, class Draw>
std::vector<SheetPicture> SheetPicturesBy(const Set& set, Framing framing, const Draw& draw) {
  std::vector<SheetPicture> pictures;
  pictures.reserve(set.items.size());
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    pictures.push_back({.row = set.items[i].object_class,
                        .split = set.items[i].split,
                        .caption = fs::path(set.items[i].image).stem().string(),
                        .draw = [&set, i, framing, draw] { return draw(set, i, framing); }});
  }
  return pictures;
}

}  // namespace

std::vector<SheetPicture> SheetPicturesOf(const LabelledImageSet& set, Framing framing) {
  return SheetPicturesBy(set, framing, DrawPicture);
}

std::vector<SheetPicture> SheetPicturesOf(const ViewSet& set, Framing framing) {
  return SheetPicturesBy(set, framing, DrawView);
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
