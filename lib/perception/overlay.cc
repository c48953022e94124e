// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"

namespace handcraft::perception {
namespace {

using Colour = std::array<float, 3>;  // blue, green, red in 0..255

Image ToColour(const Image& image) {
  HC_CHECK(image.channels() == 1 || image.channels() == 3, image.channels());
  if (image.channels() == 3) return image;
  Image colour(image.width(), image.height(), 3);
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      for (int c = 0; c < 3; ++c) colour.At(u, v, c) = image.At(u, v);
    }
  }
  return colour;
}

// pixel ← pixel + opacity · (colour − pixel)
void Blend(std::uint8_t* pixel, const Colour& colour, float opacity) {
  for (std::size_t c = 0; c < 3; ++c) {
    const auto before = static_cast<float>(pixel[c]);
    pixel[c] = static_cast<std::uint8_t>(std::lround(before + opacity * (colour[c] - before)));
  }
}

void BlendProbabilities(Image& image, const FloatImage& probabilities) {
  constexpr float kOpacityAtOne = 0.4F;  // the picture stays visible
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      const float p = std::clamp(probabilities.At(u, v), 0.0F, 1.0F);
      if (!(p > 0.0F)) continue;  // NaN draws nothing
      Blend(&image.At(u, v), {0.0F, 200.0F * (1.0F - p), 255.0F}, kOpacityAtOne * p);
    }
  }
}

// A circle with its rank beside it; dark below bright, so that it shows on any ground.
void DrawPoint(cv::Mat& canvas, const MarkedPoint& point, std::size_t rank) {
  const double scale = std::max(1.0, std::max(canvas.cols, canvas.rows) / 640.0);
  const int radius_px = static_cast<int>(std::lround(5.0 * scale));
  const int width_px = static_cast<int>(std::lround(scale));
  const cv::Point centre(point.u_px, point.v_px);
  const std::string number = std::to_string(rank);
  const double font_scale = 0.4 * scale;
  const cv::Size text_size =
      cv::getTextSize(number, cv::FONT_HERSHEY_SIMPLEX, font_scale, width_px, nullptr);
  const cv::Point text(std::min(centre.x + radius_px + 1, canvas.cols - text_size.width),
                       std::max(centre.y - radius_px + 1, text_size.height));
  const cv::Scalar dark(0, 0, 0);
  const cv::Scalar bright(80, 255, 80);
  for (const auto& [colour, extra_px] : {std::pair{dark, 2}, std::pair{bright, 0}}) {
    cv::circle(canvas, centre, radius_px, colour, width_px + extra_px, cv::LINE_AA);
    cv::putText(canvas,
                number,
                text,
                cv::FONT_HERSHEY_SIMPLEX,
                font_scale,
                colour,
                width_px + extra_px,
                cv::LINE_AA);
  }
}

}  // namespace

Image DrawGraspPoints(const Image& image,
                      const FloatImage& probabilities,
                      std::span<const MarkedPoint> points) {
  Image drawn = ToColour(image);
  if (!probabilities.empty()) {
    HC_CHECK(probabilities.width() == image.width() && probabilities.height() == image.height() &&
                 probabilities.channels() == 1,
             probabilities.width(),
             probabilities.height(),
             image.width(),
             image.height());
    BlendProbabilities(drawn, probabilities);
  }
  if (drawn.empty()) return drawn;
  cv::Mat canvas(drawn.height(), drawn.width(), CV_8UC3, drawn.Row(0));
  for (std::size_t i = points.size(); i-- > 0;) DrawPoint(canvas, points[i], i + 1);  // best on top
  return drawn;
}

Image DrawLabelMask(const Image& image, const Image& mask) {
  constexpr std::uint8_t kGood = 255;
  constexpr std::uint8_t kDontCare = 128;
  HC_CHECK(mask.width() == image.width() && mask.height() == image.height() && mask.channels() == 1,
           mask.width(),
           mask.height(),
           image.width(),
           image.height());
  Image drawn = ToColour(image);
  for (int v = 0; v < drawn.height(); ++v) {
    for (int u = 0; u < drawn.width(); ++u) {
      if (mask.At(u, v) == kGood) Blend(&drawn.At(u, v), {0.0F, 230.0F, 0.0F}, 0.6F);
      if (mask.At(u, v) == kDontCare) Blend(&drawn.At(u, v), {255.0F, 80.0F, 0.0F}, 0.3F);
    }
  }
  return drawn;
}

}  // namespace handcraft::perception
