// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/sensor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"

namespace handcraft::synthetic {
namespace {

constexpr int kCodes = 4096;

// Signal in 8-bit steps for linear values 0 ... 4, at the middle of each of 4096 bins.
std::array<float, kCodes> MakeToneCurve() {
  std::array<float, kCodes> curve{};
  for (int i = 0; i < kCodes; ++i) {
    float value = 4.0F * (static_cast<float>(i) + 0.5F) / kCodes;
    constexpr float kKnee = 0.7F;
    if (value > kKnee) value = 1.0F - (1.0F - kKnee) * std::exp(-(value - kKnee) / (1.0F - kKnee));
    const float coded =
        value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1.0F / 2.4F) - 0.055F;
    curve[static_cast<std::size_t>(i)] = 255.0F * coded;
  }
  return curve;
}

FloatImage Blur(const FloatImage& light, float blur_px) {
  FloatImage blurred = light;
  if (blur_px <= 0.0F) return blurred;
  const cv::Mat pixels(blurred.height(), blurred.width(), CV_32FC3, blurred.Row(0));
  cv::Mat target = pixels;
  cv::GaussianBlur(pixels, target, {3, 3}, static_cast<double>(blur_px), 0.0, cv::BORDER_REPLICATE);
  HC_CHECK(target.data == pixels.data, "blurred in place");
  return blurred;
}

}  // namespace

Image Develop(const FloatImage& light, const SensorModel& sensor, Rng& rng) {
  HC_CHECK(light.channels() == 3 && !light.empty(), light.channels());
  static const std::array<float, kCodes> kCurve = MakeToneCurve();
  const FloatImage blurred = Blur(light, sensor.blur_px);
  double sum = 0.0;
  for (const float value : blurred.values()) sum += static_cast<double>(value);
  const double mean = std::max(sum / static_cast<double>(blurred.values().size()), 1e-6);
  const float gain = sensor.mean_exposure / static_cast<float>(mean) * (kCodes / 4.0F);
  Image image(light.width(), light.height(), 3);
  for (int v = 0; v < light.height(); ++v) {
    for (int u = 0; u < light.width(); ++u) {
      for (int channel = 0; channel < 3; ++channel) {
        const float bin = std::clamp(gain * blurred.At(u, v, channel), 0.0F, kCodes - 1.0F);
        const float signal = kCurve[static_cast<std::size_t>(bin)];
        const float deviation =
            std::sqrt(sensor.read_noise * sensor.read_noise + sensor.shot_noise * signal);
        const float noisy = signal + deviation * static_cast<float>(rng.Normal());
        image.At(u, v, 2 - channel) =
            static_cast<std::uint8_t>(std::clamp(std::round(noisy), 0.0F, 255.0F));
      }
    }
  }
  return image;
}

}  // namespace handcraft::synthetic
