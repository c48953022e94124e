// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/sensor.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace handcraft::synthetic {
namespace {

constexpr SensorModel kClean{
    .mean_exposure = 0.2F, .read_noise = 0.0F, .shot_noise = 0.0F, .blur_px = 0.0F};

TEST(Develop, CodesTheMeanAsSrgbDoes) {
  Rng rng = Rng::Stream(1, "sensor");
  const Image image = Develop(FloatImage(20, 10, 3, 7.5F), kClean, rng);
  const double expected = 255.0 * (1.055 * std::pow(0.2, 1.0 / 2.4) - 0.055);
  for (const std::uint8_t value : image.values()) EXPECT_NEAR(value, expected, 1.0);
}

TEST(Develop, PutsBlueFirst) {
  FloatImage light(2, 2, 3, 0.1F);
  light.At(0, 0, 0) = 1.0F;  // red
  Rng rng = Rng::Stream(1, "sensor");
  const Image image = Develop(light, kClean, rng);
  EXPECT_GT(image.At(0, 0, 2), image.At(0, 0, 0));
  EXPECT_EQ(image.At(0, 0, 0), image.At(1, 1, 0));
}

TEST(Develop, CompressesHighlightsWithoutWrapping) {
  FloatImage light(100, 100, 3, 0.1F);
  light.At(5, 5, 1) = 1e6F;
  Rng rng = Rng::Stream(1, "sensor");
  EXPECT_EQ(Develop(light, kClean, rng).At(5, 5, 1), 255);
}

TEST(Develop, AddsNoiseOfTheGivenDeviation) {
  SensorModel sensor = kClean;
  sensor.read_noise = 2.0F;
  Rng rng = Rng::Stream(1, "sensor");
  const Image image = Develop(FloatImage(200, 200, 3, 1.0F), sensor, rng);
  double sum = 0.0;
  double squares = 0.0;
  for (const std::uint8_t value : image.values()) {
    sum += value;
    squares += static_cast<double>(value) * value;
  }
  const auto count = static_cast<double>(image.values().size());
  const double variance = squares / count - (sum / count) * (sum / count);
  EXPECT_NEAR(variance, 4.0 + 1.0 / 12.0, 0.1) << "noise and rounding, 120000 values";
}

TEST(Develop, BlursWithoutChangingTheMean) {
  FloatImage light(50, 50, 3, 0.0F);
  for (int channel = 0; channel < 3; ++channel) light.At(25, 25, channel) = 1.0F;
  SensorModel sensor = kClean;
  sensor.mean_exposure = 1e-4F;
  sensor.blur_px = 0.7F;
  Rng rng = Rng::Stream(1, "sensor");
  const Image image = Develop(light, sensor, rng);
  EXPECT_GT(image.At(24, 25), 0);
  EXPECT_GT(image.At(25, 25), image.At(24, 25));
  EXPECT_EQ(image.At(20, 25), image.At(0, 0));
}

TEST(Develop, ExposesDarknessWithoutDividingByZero) {
  Rng rng = Rng::Stream(1, "sensor");
  const Image image = Develop(FloatImage(4, 4, 3), kClean, rng);
  for (const std::uint8_t value : image.values()) {
    EXPECT_LT(value, 3);
  }
  EXPECT_THROW(static_cast<void>(Develop(FloatImage(4, 4, 1), kClean, rng)), std::logic_error);
}

}  // namespace
}  // namespace handcraft::synthetic
