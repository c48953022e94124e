// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/lib/features/feature_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handcraft::features::testing {
namespace {

// One channel as doubles in 0..1; reads outside give the nearest pixel.
struct Plane {
  int width = 0;
  int height = 0;
  std::vector<double> values;

  [[nodiscard]] double At(int x, int y) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

std::array<Plane, 3> ToPlanes(const RawImage& image) {
  std::array<Plane, 3> planes;
  for (Plane& plane : planes) plane = {image.width, image.height, {}};
  const int channels = NumChannels(image.format);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* p = image.data + y * image.stride_bytes + std::ptrdiff_t{x} * channels;
      Ycbcr pixel{p[0], 128, 128};
      if (image.format == PixelFormat::kBgr8) pixel = ToYcbcr(p[2], p[1], p[0]);
      if (image.format == PixelFormat::kRgb8) pixel = ToYcbcr(p[0], p[1], p[2]);
      planes[0].values.push_back(pixel.y / 255.0);
      planes[1].values.push_back(pixel.cb / 255.0);
      planes[2].values.push_back(pixel.cr / 255.0);
    }
  }
  return planes;
}

Plane Shrink(const Plane& plane, int reduction) {
  Plane small{
      (plane.width + reduction - 1) / reduction, (plane.height + reduction - 1) / reduction, {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      double sum = 0.0;
      int count = 0;
      for (int i = y * reduction; i < std::min((y + 1) * reduction, plane.height); ++i) {
        for (int j = x * reduction; j < std::min((x + 1) * reduction, plane.width); ++j, ++count) {
          sum += plane.At(j, i);
        }
      }
      small.values.push_back(sum / count);
    }
  }
  return small;
}

double EnergyAt(const std::array<Plane, 3>& planes, Filter filter, Energy energy, int x, int y) {
  const Plane& plane = planes[filter == Filter::kChromaBlueLL  ? 1
                              : filter == Filter::kChromaRedLL ? 2
                                                               : 0];
  const FilterKernels kernels = KernelsOf(filter);
  double sum_of_squares = 0.0;
  for (int c = 0; c < kernels.num_components; ++c) {
    double response = 0.0;
    for (int i = 0; i < kKernelSize; ++i) {
      for (int j = 0; j < kKernelSize; ++j) {
        const double weight = static_cast<double>(kernels.components[static_cast<std::size_t>(
            c)][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
        response += weight * plane.At(x - (j - 3), y - (i - 3));
      }
    }
    sum_of_squares += response * response;
  }
  if (energy == Energy::kAbs) return std::sqrt(sum_of_squares);
  if (energy == Energy::kLog) return std::log(sum_of_squares + 1e-5);
  return sum_of_squares;
}

}  // namespace

Picture MakePicture(int width, int height, PixelFormat format, std::uint64_t seed, int gap) {
  Picture picture;
  const int channels = NumChannels(format);
  const int stride = width * channels + gap;
  picture.bytes.assign(static_cast<std::size_t>(stride) * static_cast<std::size_t>(height), 7);
  Rng rng(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width * channels; ++x) {
      const int step = (x / 37 + y / 23) % 3 * 60;
      const double wave = 40.0 * std::sin(0.07 * x + 0.11 * y);
      const double noise = (x / 50) % 2 == 0 ? 10.0 * rng.Normal() : 0.0;
      picture.bytes[static_cast<std::size_t>(y * stride + x)] =
          static_cast<std::uint8_t>(std::clamp(60.0 + step + wave + noise, 0.0, 255.0));
    }
  }
  picture.raw = {picture.bytes.data(), width, height, stride, format};
  return picture;
}

std::vector<double> OracleFeatures(const RawImage& image, const FeatureSpec& spec, int u, int v) {
  const std::array<Plane, 3> planes = ToPlanes(image);
  std::vector<double> features;
  const int radius = spec.window / 2;
  for (int dv = -radius; dv <= radius; ++dv) {
    for (int du = -radius; du <= radius; ++du) {
      const int x = std::clamp(u + du, 0, image.width - 1);
      const int y = std::clamp(v + dv, 0, image.height - 1);
      for (const Filter filter : spec.filters) {
        features.push_back(EnergyAt(planes, filter, spec.energy, x, y));
      }
    }
  }
  for (const int scale : spec.scales) {
    const std::array<Plane, 3> small = {
        Shrink(planes[0], scale), Shrink(planes[1], scale), Shrink(planes[2], scale)};
    for (const Filter filter : spec.filters) {
      features.push_back(EnergyAt(small, filter, spec.energy, u / scale, v / scale));
    }
  }
  return features;
}

std::vector<float> RandomWeights(int count, double scale, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<float> weights(static_cast<std::size_t>(count));
  for (float& weight : weights) weight = static_cast<float>(scale * rng.Normal());
  return weights;
}

}  // namespace handcraft::features::testing
