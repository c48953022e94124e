// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

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

constexpr Colour kBlue = {255.0F, 80.0F, 0.0F};

// The picture in colour, each pixel changed by tint(value of the mask, pixel).
template <class TintPixel>
Image Tint(const Image& image, const Image& mask, const TintPixel& tint) {
  HC_CHECK(mask.width() == image.width() && mask.height() == image.height() && mask.channels() == 1,
           mask.width(),
           mask.height(),
           image.width(),
           image.height());
  Image drawn = ToColour(image);
  for (int v = 0; v < drawn.height(); ++v) {
    for (int u = 0; u < drawn.width(); ++u) tint(mask.At(u, v), &drawn.At(u, v));
  }
  return drawn;
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

constexpr std::uint8_t kGood = 255;

// Around what is good a line, white next to it and black beyond, so that it shows on any ground: on
// a green object, too. As wide as needs be in a picture that is made small.
void Outline(const Image& mask, Image& drawn) {
  const auto& labels = mask.values();
  if (std::find(labels.begin(), labels.end(), kGood) == labels.end()) return;
  // OpenCV takes no pointer to const, but only reads.
  const cv::Mat all(mask.height(), mask.width(), CV_8UC1, const_cast<std::uint8_t*>(mask.Row(0)));
  const cv::Mat good = all == kGood;
  const int width_px = cvRound(std::max(mask.width(), mask.height()) / 256.0);
  cv::Mat canvas(drawn.height(), drawn.width(), CV_8UC3, drawn.Row(0));
  cv::Mat inner = good;
  for (const int level : {255, 0}) {
    cv::Mat outer;
    cv::dilate(
        inner,
        outer,
        cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * width_px + 1, 2 * width_px + 1)));
    canvas.setTo(cv::Scalar::all(level), outer & ~inner);
    inner = outer;
  }
}

// Dark below bright, so that it shows on any ground.
template <class Draw>
void DrawTwice(int width_px, const Draw& draw) {
  draw(cv::Scalar(0, 0, 0), width_px + 2);
  draw(cv::Scalar(80, 255, 80), width_px);
}

// Circles with their ranks beside them. A number goes to the first of some places around its circle
// where it covers no circle and no better number; where there is none, the circle stands alone.
class PointDrawing {
 public:
  PointDrawing(cv::Mat& canvas, std::span<const MarkedPoint> points)
      : canvas_(canvas), points_(points) {
    for (std::size_t i = points_.size(); i-- > 0;) DrawCircle(points_[i]);  // best on top
    for (std::size_t i = 0; i < points_.size(); ++i) DrawRank(i);
  }

 private:
  void DrawCircle(const MarkedPoint& point) {
    const cv::Point centre(point.u_px, point.v_px);
    DrawTwice(width_px_, [&](const cv::Scalar& colour, int width_px) {
      cv::circle(canvas_, centre, radius_px_, colour, width_px, cv::LINE_AA);
    });
    taken_.emplace_back(centre - cv::Point(radius_px_, radius_px_),
                        cv::Size(2 * radius_px_ + 1, 2 * radius_px_ + 1));
  }

  void DrawRank(std::size_t i) {
    const std::string number = std::to_string(i + 1);
    const cv::Size size =
        cv::getTextSize(number, cv::FONT_HERSHEY_SIMPLEX, font_scale_, width_px_, nullptr);
    const cv::Rect whole(0, 0, canvas_.cols, canvas_.rows);
    for (const double distance : {1.0, 1.6}) {
      for (int eighth = 0; eighth < 8; ++eighth) {
        const cv::Rect place = Beside(points_[i], size, eighth, distance);
        if ((place & whole) != place || IsTaken(place)) continue;
        DrawTwice(width_px_, [&](const cv::Scalar& colour, int width_px) {
          const cv::Point corner(place.x, place.y + place.height);
          cv::putText(canvas_,
                      number,
                      corner,
                      cv::FONT_HERSHEY_SIMPLEX,
                      font_scale_,
                      colour,
                      width_px,
                      cv::LINE_AA);
        });
        taken_.push_back(place);
        return;
      }
    }
  }

  // Centred on a ray from the point, in the direction of that eighth of a turn from the upper
  // right.
  [[nodiscard]] cv::Rect Beside(const MarkedPoint& point,
                                cv::Size size,
                                int eighth,
                                double distance) const {
    const double angle = (eighth - 1) * CV_PI / 4.0;
    const double reach = distance * (radius_px_ + 0.5 * size.width + 2.0);
    return {cvRound(point.u_px + reach * std::cos(angle) - 0.5 * size.width),
            cvRound(point.v_px + reach * std::sin(angle) - 0.5 * size.height),
            size.width,
            size.height};
  }

  [[nodiscard]] bool IsTaken(const cv::Rect& place) const {
    return std::any_of(taken_.begin(), taken_.end(), [&](const cv::Rect& other) {
      return (other & place).area() > 0;
    });
  }

  cv::Mat& canvas_;
  std::span<const MarkedPoint> points_;
  double scale_ = std::max(1.0, std::max(canvas_.cols, canvas_.rows) / 640.0);
  int radius_px_ = static_cast<int>(std::lround(5.0 * scale_));
  int width_px_ = static_cast<int>(std::lround(scale_));
  double font_scale_ = 0.4 * scale_;
  std::vector<cv::Rect> taken_;
};

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
  const PointDrawing drawing(canvas, points);
  return drawn;
}

Image DrawLabelMask(const Image& image, const Image& mask) {
  constexpr std::uint8_t kDontCare = 128;
  Image drawn = Tint(image, mask, [](std::uint8_t label, std::uint8_t* pixel) {
    if (label == kGood) Blend(pixel, {0.0F, 230.0F, 0.0F}, 0.6F);
    if (label == kDontCare) Blend(pixel, kBlue, 0.3F);
  });
  Outline(mask, drawn);
  return drawn;
}

Image DrawRegion(const Image& image, const Image& mask) {
  return Tint(image, mask, [](std::uint8_t wanted, std::uint8_t* pixel) {
    if (wanted != 0) Blend(pixel, kBlue, 0.5F);
  });
}

}  // namespace handcraft::perception
