// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/report_pictures.h"

#include <algorithm>
#include <cstring>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"

namespace handcraft::experiments {
namespace {

constexpr int kJpegQuality = 82;
constexpr int kCloseUpShare = 6;
constexpr int kMinCloseUpPx = 32;
constexpr int kCloseUpSidePx = 280;  // the longer one

// OpenCV takes no const pixels; these are only read.
cv::Mat MatOf(const Image& image) {
  return {image.height(),
          image.width(),
          CV_8UC(image.channels()),
          const_cast<std::uint8_t*>(image.Row(0))};
}

Image ImageOf(const cv::Mat& mat) {
  Image image(mat.cols, mat.rows, mat.channels());
  for (int v = 0; v < mat.rows; ++v) {
    std::memcpy(image.Row(v), mat.ptr(v), static_cast<std::size_t>(mat.cols) * mat.elemSize());
  }
  return image;
}

// A window of about 1/kCloseUpShare of the side around the centre, moved inside the picture.
cv::Range WindowAround(int centre, int side) {
  const int length = std::min(side, std::max(kMinCloseUpPx, side / kCloseUpShare));
  const int start = std::clamp(centre - length / 2, 0, side - length);
  return {start, start + length};
}

cv::Scalar ColourOf(std::uint8_t mask_value) {
  if (mask_value == datasets::kMaskGood) return {70, 230, 60};
  if (mask_value == datasets::kMaskBad) return {50, 60, 240};
  return {255, 170, 60};
}

}  // namespace

std::vector<std::uint8_t> EncodeJpeg(const Image& image, int max_width_px) {
  HC_CHECK(
      !image.empty() && image.channels() == 3, image.width(), image.height(), image.channels());
  const cv::Mat full = MatOf(image);
  cv::Mat shown = full;
  if (image.width() > max_width_px) {
    const double scale = static_cast<double>(max_width_px) / image.width();
    const int height = std::max(1, cvRound(scale * image.height()));
    cv::resize(full, shown, cv::Size(max_width_px, height), 0.0, 0.0, cv::INTER_AREA);
  }
  std::vector<std::uint8_t> bytes;
  const bool is_encoded =
      cv::imencode(".jpg", shown, bytes, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  HC_CHECK(is_encoded, image.width(), image.height());
  return bytes;
}

Image DrawCloseUp(const Image& picture, std::span<const BestPixel> best) {
  if (best.empty()) return {};
  const cv::Range columns = WindowAround(best.front().u_px, picture.width());
  const cv::Range rows = WindowAround(best.front().v_px, picture.height());
  cv::Mat colour = MatOf(picture)(rows, columns);
  if (picture.channels() == 1) cv::cvtColor(colour, colour, cv::COLOR_GRAY2BGR);
  const double scale = static_cast<double>(kCloseUpSidePx) / std::max(columns.size(), rows.size());
  const cv::Size size(std::max(1, cvRound(scale * columns.size())),
                      std::max(1, cvRound(scale * rows.size())));
  cv::Mat shown;
  cv::resize(colour, shown, size, 0.0, 0.0, cv::INTER_CUBIC);
  // Best on top; a dark ring below the bright one shows on any ground.
  for (auto pixel = best.rbegin(); pixel != best.rend(); ++pixel) {
    const cv::Point centre(cvRound(scale * (pixel->u_px - columns.start + 0.5)),
                           cvRound(scale * (pixel->v_px - rows.start + 0.5)));
    cv::circle(shown, centre, 5, cv::Scalar(0, 0, 0), 4, cv::LINE_AA);
    cv::circle(shown, centre, 5, ColourOf(pixel->mask_value), 2, cv::LINE_AA);
  }
  return ImageOf(shown);
}

}  // namespace handcraft::experiments
