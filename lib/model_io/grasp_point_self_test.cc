// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/grasp_point_self_test.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>

#include "lib/core/rng.h"
#include "lib/features/pixel_features.h"
#include "lib/features/pixel_scorer.h"
#include "lib/runtime/aligned_buffer.h"
#include "lib/runtime/grasp_point_model.h"

namespace handcraft::model_io {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;

features::RawImage RawViewOf(const Image& picture) {
  return {.data = picture.values().data(),
          .width = picture.width(),
          .height = picture.height(),
          .stride_bytes = std::ptrdiff_t{3} * picture.width(),
          .format = features::PixelFormat::kBgr8};
}

std::vector<float> Score(const Image& picture,
                         const features::FeatureSpec& spec,
                         std::span<const float> weights,
                         double intercept,
                         features::InstructionSet set) {
  const features::PixelScorer scorer(spec, weights, intercept, set);
  const runtime::AlignedBuffer workspace(scorer.WorkspaceBytes(kWidth, kHeight));
  std::vector<float> probabilities(std::size_t{kWidth} * kHeight);
  scorer.Score(RawViewOf(picture), workspace.Bytes(), probabilities.data(), kWidth);
  return probabilities;
}

// Largest |intercept| + Σ |w · x| of a pixel: what the roundings of its sum are relative to.
double LargestSum(const Image& picture,
                  const features::FeatureSpec& spec,
                  std::span<const float> weights,
                  double intercept) {
  const features::PixelFeatures features(RawViewOf(picture), spec);
  std::vector<float> x(weights.size());
  double largest = 0.0;
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      features.Gather(u, v, x);
      double sum = std::fabs(intercept);
      for (std::size_t i = 0; i < x.size(); ++i)
        sum += std::fabs(double{weights[i]} * double{x[i]});
      largest = std::max(largest, sum);
    }
  }
  return largest;
}

}  // namespace

Image SelfTestPicture() {
  Image picture(kWidth, kHeight, 3);
  Rng rng(1);
  for (int v = 0; v < kHeight; ++v) {
    for (int u = 0; u < kWidth; ++u) {
      const bool disc = (u - 12) * (u - 12) + (v - 14) * (v - 14) < 49;
      const bool bar = u + v > 44 && u + v < 50;
      const int noise = u >= kWidth / 2 ? static_cast<int>(rng.UniformInt(64)) : 0;
      const int base = disc ? 180 : bar ? 10 : 40 + 2 * u;
      picture.At(u, v, 0) = static_cast<std::uint8_t>(disc ? 30 : 200 - 4 * u + noise / 2);
      picture.At(u, v, 1) = static_cast<std::uint8_t>(base + noise);
      picture.At(u, v, 2) = static_cast<std::uint8_t>(disc ? 230 : 20 + 4 * v + noise);
    }
  }
  return picture;
}

GraspPointSelfTest MakeGraspPointSelfTest(const features::FeatureSpec& spec,
                                          std::span<const float> weights,
                                          double intercept) {
  GraspPointSelfTest test;
  test.picture = SelfTestPicture();
  const std::span<const features::InstructionSet> sets = features::SupportedInstructionSets();
  test.probabilities = Score(test.picture, spec, weights, intercept, sets.back());
  float difference = 0.0F;
  for (const features::InstructionSet set : sets) {
    const std::vector<float> other = Score(test.picture, spec, weights, intercept, set);
    for (std::size_t i = 0; i < other.size(); ++i) {
      difference = std::max(difference, std::fabs(other[i] - test.probabilities[i]));
    }
  }
  // |dp/dz| ≤ 1/4; a rounding in single precision is 2^-24 of the sum.
  const double roundings =
      16.0 * 0.25 * std::ldexp(LargestSum(test.picture, spec, weights, intercept), -24);
  test.tolerance = std::clamp(std::max(16.0F * difference, static_cast<float>(roundings)),
                              1e-5F,
                              runtime::kMaxSelfTestTolerance);
  return test;
}

}  // namespace handcraft::model_io
