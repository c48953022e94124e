// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/perception/cloud_outliers.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/core/option_rules.h"

namespace handcraft::perception {
namespace {

// Order statistic number q · (n − 1); reorders the values.
double Quantile(std::vector<float>& values, double q) {
  const double rank = q * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), below, values.end());
  const double low = *below;
  const double part = rank - std::floor(rank);
  if (part == 0.0) return low;
  return low + part * (static_cast<double>(*std::min_element(below + 1, values.end())) - low);
}

}  // namespace

void CloudOutlierOptions::Validate() const {
  RequireOption(step >= 0.0F && step <= 100.0F, "CloudOutlierOptions.step", step, "in [0, 100]");
  RequireOption(max_samples >= 4, "CloudOutlierOptions.max_samples", max_samples, "4 or more");
}

Fence FenceOf(std::span<const float> values, const CloudOutlierOptions& options) {
  if (values.empty()) return {};
  const auto most = static_cast<std::size_t>(options.max_samples);
  const std::size_t stride = (values.size() + most - 1) / most;
  std::vector<float> sample;
  sample.reserve(values.size() / stride + 1);
  for (std::size_t i = 0; i < values.size(); i += stride) sample.push_back(values[i]);
  const double lower_quartile = Quantile(sample, 0.25);
  const double upper_quartile = Quantile(sample, 0.75);
  const double step = static_cast<double>(options.step) * (upper_quartile - lower_quartile);
  return {static_cast<float>(lower_quartile - step),   // Eq. (3.3)
          static_cast<float>(upper_quartile + step)};  // Eq. (3.4)
}

void RemoveOutliers(PixelPoints& points, const CloudOutlierOptions& options) {
  const std::array<Fence, 3> fences = {FenceOf(points.Coordinates(0), options),
                                       FenceOf(points.Coordinates(1), options),
                                       FenceOf(points.Coordinates(2), options)};
  points.Filter([&](float x, float y, float z) {
    return x >= fences[0].lower && x <= fences[0].upper && y >= fences[1].lower &&
           y <= fences[1].upper && z >= fences[2].lower && z <= fences[2].upper;
  });
}

}  // namespace handcraft::perception
