// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/opencv_scorers.h"

#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "lib/core/check.h"

namespace handcraft::experiments {
namespace {

cv::Mat ToFloat(const Image& gray) {
  const cv::Mat bytes(gray.height(), gray.width(), CV_8UC1, const_cast<std::uint8_t*>(gray.Row(0)));
  cv::Mat values;
  bytes.convertTo(values, CV_32F, 1.0 / 255.0);
  return values;
}

// The kernel cut to its non-zero square, flipped because filter2D correlates.
cv::Mat ToMat(const features::Kernel& kernel) {
  cv::Mat whole(features::kKernelSize, features::kKernelSize, CV_32F);
  int reach = 0;
  for (int i = 0; i < features::kKernelSize; ++i) {
    for (int j = 0; j < features::kKernelSize; ++j) {
      const float weight = kernel[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      whole.at<float>(i, j) = weight;
      if (weight != 0.0F) reach = std::max({reach, std::abs(i - 3), std::abs(j - 3)});
    }
  }
  cv::Mat flipped;
  cv::flip(whole(cv::Rect(3 - reach, 3 - reach, 2 * reach + 1, 2 * reach + 1)), flipped, -1);
  return flipped;
}

cv::Mat Filter2D(const cv::Mat& input, const cv::Mat& kernel) {
  cv::Mat output;
  cv::filter2D(input, output, CV_32F, kernel, cv::Point(-1, -1), 0, cv::BORDER_REPLICATE);
  return output;
}

std::vector<cv::Mat> Energies(const Image& gray, const features::FeatureSpec& spec) {
  const cv::Mat y = ToFloat(gray);
  std::vector<cv::Mat> energies;
  for (const features::Filter filter : spec.filters) {
    const features::FilterKernels kernels = features::KernelsOf(filter);
    cv::Mat energy;
    for (int c = 0; c < kernels.num_components; ++c) {
      const cv::Mat response = Filter2D(y, ToMat(kernels.components[static_cast<std::size_t>(c)]));
      const cv::Mat square = response.mul(response);
      energy = c == 0 ? square : cv::Mat(energy + square);
    }
    if (spec.energy == features::Energy::kAbs) cv::sqrt(energy, energy);
    if (spec.energy == features::Energy::kLog) cv::log(energy + features::kLogEnergyOffset, energy);
    energies.push_back(energy);
  }
  return energies;
}

float Sigmoid(float z) { return 1.0F / (1.0F + std::exp(-z)); }

}  // namespace

FloatImage ScoreByGathering(const Image& gray,
                            const features::FeatureSpec& spec,
                            std::span<const float> weights,
                            float intercept) {
  HC_CHECK(spec.scales.empty() && gray.channels() == 1);
  const std::vector<cv::Mat> energies = Energies(gray, spec);
  const int radius = spec.window / 2;
  std::vector<cv::Mat> padded(energies.size());
  for (std::size_t f = 0; f < energies.size(); ++f) {
    cv::copyMakeBorder(
        energies[f], padded[f], radius, radius, radius, radius, cv::BORDER_REPLICATE);
  }
  FloatImage probabilities(gray.width(), gray.height());
  std::vector<float> features(weights.size());
  for (int v = 0; v < gray.height(); ++v) {
    for (int u = 0; u < gray.width(); ++u) {
      std::size_t i = 0;
      for (int dv = 0; dv < spec.window; ++dv) {
        for (int du = 0; du < spec.window; ++du) {
          for (const cv::Mat& energy : padded) features[i++] = energy.at<float>(v + dv, u + du);
        }
      }
      float z = intercept;
      for (i = 0; i < features.size(); ++i) z += weights[i] * features[i];
      probabilities.At(u, v) = Sigmoid(z);
    }
  }
  return probabilities;
}

FloatImage ScoreByConvolutions(const Image& gray,
                               const features::FeatureSpec& spec,
                               std::span<const float> weights,
                               float intercept) {
  HC_CHECK(spec.scales.empty() && gray.channels() == 1);
  const std::vector<cv::Mat> energies = Energies(gray, spec);
  cv::Mat sum(gray.height(), gray.width(), CV_32F, cv::Scalar(static_cast<double>(intercept)));
  for (std::size_t f = 0; f < energies.size(); ++f) {
    cv::Mat kernel(spec.window, spec.window, CV_32F);
    for (int i = 0; i < spec.window * spec.window; ++i) {
      kernel.at<float>(i / spec.window, i % spec.window) =
          weights[static_cast<std::size_t>(i) * energies.size() + f];
    }
    sum += Filter2D(energies[f], kernel);
  }
  FloatImage probabilities(gray.width(), gray.height());
  for (int v = 0; v < gray.height(); ++v) {
    for (int u = 0; u < gray.width(); ++u) probabilities.At(u, v) = Sigmoid(sum.at<float>(v, u));
  }
  return probabilities;
}

}  // namespace handcraft::experiments
