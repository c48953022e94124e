// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/search_region.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"
#include "lib/core/option_rules.h"

namespace handcraft::perception {
namespace {

// OpenCV has no read-only matrix; the pixels are only read.
cv::Mat MatOf(const Image& image) {
  return {image.height(),
          image.width(),
          CV_8UC(image.channels()),
          const_cast<std::uint8_t*>(image.values().data())};
}

cv::Rect RectOf(const PixelBox& box) { return {box.u_px, box.v_px, box.width, box.height}; }

// The bounding box of the pixels, larger by the margin, inside the picture.
PixelBox BoxOf(const PixelPoints& points, const Image& image, int margin_px) {
  int left = image.width();
  int right = -1;
  for (const std::int32_t pixel : points.Pixels()) {
    left = std::min(left, pixel % image.width());
    right = std::max(right, pixel % image.width());
  }
  const int top = points.Pixels().front() / image.width();  // they ascend
  const int bottom = points.Pixels().back() / image.width();
  const int u = std::max(0, left - margin_px);
  const int v = std::max(0, top - margin_px);
  return {.u_px = u,
          .v_px = v,
          .width = std::min(image.width() - 1, right + margin_px) - u + 1,
          .height = std::min(image.height() - 1, bottom + margin_px) - v + 1};
}

// 255 within margin_px of the points, a picture of the crop.
cv::Mat NearPoints(const PixelPoints& points,
                   int picture_width,
                   const PixelBox& crop,
                   int margin_px) {
  cv::Mat near = cv::Mat::zeros(crop.height, crop.width, CV_8U);
  for (const std::int32_t pixel : points.Pixels()) {
    near.at<std::uint8_t>(pixel / picture_width - crop.v_px, pixel % picture_width - crop.u_px) =
        255;
  }
  const int side = 2 * margin_px + 1;
  if (side > 1) cv::dilate(near, near, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  return near;
}

cv::Mat EdgesOf(const Image& image, const PixelBox& crop, const SearchRegionOptions& options) {
  cv::Mat gray = MatOf(image)(RectOf(crop));
  if (image.channels() == 3) {
    cv::Mat converted;
    cv::cvtColor(gray, converted, cv::COLOR_BGR2GRAY);
    gray = converted;
  }
  cv::Mat edges;
  cv::Canny(
      gray, edges, static_cast<double>(options.canny_low), static_cast<double>(options.canny_high));
  return edges;
}

class StageClock {
 public:
  explicit StageClock(std::vector<SearchStage>& stages) : stages_(stages) {}

  void Done(std::string_view name, std::size_t num_pixels) {
    const auto now = std::chrono::steady_clock::now();
    stages_.push_back({.name = name,
                       .num_pixels = num_pixels,
                       .time_ms = std::chrono::duration<double, std::milli>(now - start_).count()});
    start_ = now;
  }

 private:
  std::vector<SearchStage>& stages_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::size_t NumPixels(const cv::Mat& mask) {
  return static_cast<std::size_t>(cv::countNonZero(mask));
}

}  // namespace

void SearchRegionOptions::Validate() const {
  table.Validate();
  outliers.Validate();
  RequireOption(
      margin_px >= 0 && margin_px <= 100, "SearchRegionOptions.margin_px", margin_px, "0 to 100");
  RequireOption(canny_low >= 0.0F && canny_low <= canny_high,
                "SearchRegionOptions.canny_low",
                canny_low,
                "0 or more and at most canny_high");
  RequireOption(
      canny_high <= 10000.0F, "SearchRegionOptions.canny_high", canny_high, "10000 or less");
}

std::string_view MessageOf(SearchState state) noexcept {
  switch (state) {
    case SearchState::kFound:
      return "The region was found.";
    case SearchState::kNoTable:
      return "No support was found: the region is that of all points.";
    case SearchState::kNoPoints:
      return "The cloud has no measured point.";
    case SearchState::kNothingLeft:
      return "Every measured point lies on the support.";
    case SearchState::kNoEdges:
      return "The picture shows no edge where the object is.";
  }
  return "Unknown state.";
}

std::vector<std::int32_t> PixelsOf(const Image& mask) {
  std::vector<std::int32_t> pixels;
  std::int32_t pixel = 0;
  for (const std::uint8_t value : mask.values()) {
    if (value != 0) pixels.push_back(pixel);
    ++pixel;
  }
  return pixels;
}

SearchRegionFinder::SearchRegionFinder(SearchRegionOptions options) : options_(std::move(options)) {
  options_.Validate();
}

SearchRegion SearchRegionFinder::Find(const Image& image, const CloudView& cloud) {
  HC_CHECK(image.width() == cloud.width && image.height() == cloud.height,
           image.width(),
           image.height(),
           cloud.width,
           cloud.height);
  HC_CHECK(image.empty() || image.channels() == 1 || image.channels() == 3, image.channels());
  SearchRegion region;
  region.mask = Image(image.width(), image.height());
  FindObject(cloud, region);
  if (region.HasRegion()) FindEdges(image, region);
  return region;
}

void SearchRegionFinder::FindObject(const CloudView& cloud, SearchRegion& region) {
  region.stages.push_back({.name = "picture", .num_pixels = cloud.points.size()});
  StageClock clock(region.stages);
  TablePlanes table = FindTable(cloud, options_.table);
  region.table = std::move(table.planes);
  const std::size_t num_measured =
      TakePointsOffPlanes(cloud, region.table, options_.table.epsilon_m, points_);
  region.stages.push_back({.name = "measured", .num_pixels = num_measured});
  clock.Done("off the table", points_.size());
  if (num_measured == 0) return;
  RemoveOutliers(points_, options_.outliers);
  clock.Done("without outliers", points_.size());
  region.state = points_.empty()                       ? SearchState::kNothingLeft
                 : table.state == TableState::kNoPlane ? SearchState::kNoTable
                                                       : SearchState::kFound;
}

void SearchRegionFinder::FindEdges(const Image& image, SearchRegion& region) const {
  StageClock clock(region.stages);
  region.crop = BoxOf(points_, image, options_.margin_px);
  cv::Mat near;
  if (options_.shape == CropShape::kOutline) {
    near = NearPoints(points_, image.width(), region.crop, options_.margin_px);
  }
  clock.Done("crop",
             near.empty() ? static_cast<std::size_t>(RectOf(region.crop).area()) : NumPixels(near));
  cv::Mat edges = EdgesOf(image, region.crop, options_);
  if (!near.empty()) cv::bitwise_and(edges, near, edges);
  const std::size_t num_edges = NumPixels(edges);
  clock.Done("edges", num_edges);
  if (num_edges == 0) {
    region.state = SearchState::kNoEdges;
    return;
  }
  cv::Mat whole(image.height(), image.width(), CV_8U, region.mask.Row(0));
  cv::Mat mask = whole(RectOf(region.crop));
  cv::dilate(edges, mask, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
  clock.Done("region", NumPixels(mask));
}

}  // namespace handcraft::perception
