// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/grasp_point_self_test.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lib/core/sha256.h"
#include "lib/features/pixel_features.h"

namespace handcraft::model_io {
namespace {

using features::FeatureSpec;
using features::ParseFeatureSpec;

TEST(SelfTestPicture, IsAlwaysTheSame) {
  const Image picture = SelfTestPicture();
  EXPECT_EQ(picture.width(), 40);
  EXPECT_EQ(picture.height(), 30);
  EXPECT_EQ(picture.channels(), 3);
  EXPECT_EQ(picture.values(), SelfTestPicture().values());
}

TEST(SelfTestPicture, MakesEveryFilterAnswer) {
  const Image picture = SelfTestPicture();
  const FeatureSpec spec = ParseFeatureSpec("filters=all+chroma,window=1");
  const features::PixelFeatures features({.data = picture.values().data(),
                                          .width = 40,
                                          .height = 30,
                                          .stride_bytes = 120,
                                          .format = features::PixelFormat::kBgr8},
                                         spec);
  for (int f = 0; f < spec.NumFilters(); ++f) {
    float smallest = 1e30F;
    float largest = 0.0F;
    for (int v = 0; v < 30; ++v) {
      for (int u = 0; u < 40; ++u) {
        smallest = std::min(smallest, features.EnergyPlane(f).At(u, v));
        largest = std::max(largest, features.EnergyPlane(f).At(u, v));
      }
    }
    EXPECT_GT(largest, 2.0F * smallest) << NameOf(spec.filters[static_cast<std::size_t>(f)]);
  }
}

TEST(MakeGraspPointSelfTest, GivesTheProbabilityByHand) {
  const FeatureSpec spec = ParseFeatureSpec("filters=laplacian,window=1");
  const float weights[] = {3.0F};
  const GraspPointSelfTest test = MakeGraspPointSelfTest(spec, weights, -0.5);
  const features::PixelFeatures features({.data = test.picture.values().data(),
                                          .width = 40,
                                          .height = 30,
                                          .stride_bytes = 120,
                                          .format = features::PixelFormat::kBgr8},
                                         spec);
  ASSERT_EQ(test.probabilities.size(), 1200U);
  for (int i = 0; i < 1200; ++i) {
    const double z = -0.5 + 3.0 * double{features.EnergyPlane(0).At(i % 40, i / 40)};
    EXPECT_NEAR(test.probabilities[static_cast<std::size_t>(i)], 1.0 / (1.0 + std::exp(-z)), 1e-6);
  }
  EXPECT_EQ(test.tolerance, 1e-5F);
}

TEST(MakeGraspPointSelfTest, AllowsMoreWhereRoundingMattersMore) {
  const FeatureSpec spec = ParseFeatureSpec("edges54,energy=log");
  std::vector<float> weights(54);
  // Large weights that nearly cancel, as collinear features make them.
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] = i % 2 == 0 ? 300.0F : -300.0F;
  const GraspPointSelfTest test = MakeGraspPointSelfTest(spec, weights, 0.0);
  EXPECT_GT(test.tolerance, 1e-3F);
  EXPECT_LE(test.tolerance, 0.1F);
}

}  // namespace
}  // namespace handcraft::model_io
