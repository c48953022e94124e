// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/material.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace handcraft::synthetic {
namespace {

using Eigen::Vector3f;

TEST(ValueNoise, StaysWithinZeroAndOneAndUsesThatRange) {
  Rng rng = Rng::Stream(1, "noise");
  float lowest = 1.0F;
  float highest = 0.0F;
  double sum = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const auto draw = [&] { return 2000.0F * static_cast<float>(rng.Uniform() - 0.5); };
    const float value = ValueNoise({draw(), draw(), draw()});
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
    sum += static_cast<double>(value);
  }
  EXPECT_GE(lowest, 0.0F);
  EXPECT_LE(highest, 1.0F);
  EXPECT_LT(lowest, 0.05F);
  EXPECT_GT(highest, 0.95F);
  EXPECT_NEAR(sum / 20000, 0.5, 0.01);
}

TEST(ValueNoise, IsContinuousAcrossTheLattice) {
  for (int i = -50; i < 50; ++i) {
    const auto x = static_cast<float>(i);
    EXPECT_NEAR(ValueNoise({x - 1e-4F, 0.3F, 7.7F}), ValueNoise({x + 1e-4F, 0.3F, 7.7F}), 1e-3F);
  }
}

TEST(FromHsv, KnowsThePrimariesAndTheGrays) {
  EXPECT_TRUE(FromHsv(0.0F, 1.0F, 1.0F).isApprox(Colour(1, 0, 0), 1e-5F));
  EXPECT_TRUE(FromHsv(1.0F / 3.0F, 1.0F, 1.0F).isApprox(Colour(0, 1, 0), 1e-4F));
  EXPECT_TRUE(FromHsv(2.0F / 3.0F, 1.0F, 1.0F).isApprox(Colour(0, 0, 1), 1e-4F));
  EXPECT_TRUE(FromHsv(0.4F, 0.0F, 0.5F).isApprox(Colour::Constant(std::pow(0.5F, 2.2F)), 1e-5F));
}

TEST(Albedo, LiesBetweenTheTwoColoursForEveryPattern) {
  Rng rng = Rng::Stream(1, "points");
  for (const Pattern pattern : {Pattern::kPlain,
                                Pattern::kSpeckled,
                                Pattern::kStripes,
                                Pattern::kWood,
                                Pattern::kChecks,
                                Pattern::kPrint,
                                Pattern::kLabel}) {
    const Material material{
        .base = {0.2F, 0.4F, 0.6F}, .second = {0.5F, 0.3F, 0.1F}, .pattern = pattern};
    for (int i = 0; i < 500; ++i) {
      const auto draw = [&] { return static_cast<float>(rng.Uniform()); };
      const Colour colour = Albedo(material, {draw(), draw(), draw()});
      EXPECT_TRUE(
          (colour.array() >= material.base.cwiseMin(material.second).array() - 1e-6F).all());
      EXPECT_TRUE(
          (colour.array() <= material.base.cwiseMax(material.second).array() + 1e-6F).all());
    }
  }
}

TEST(DrawnMaterials, ReflectNoMoreThanAllLightAndDifferByDraw) {
  for (Material (*draw)(Rng&) : {DrawGlaze, DrawPlastic, DrawTableTop, DrawBackground}) {
    Rng rng = Rng::Stream(3, "materials");
    Colour previous = Colour::Zero();
    for (int i = 0; i < 200; ++i) {
      const Material material = draw(rng);
      EXPECT_GE(material.base.minCoeff(), 0.0F);
      EXPECT_LE(material.base.maxCoeff() + material.specular, 1.0F);
      EXPECT_LE(material.second.maxCoeff(), 1.0F);
      EXPECT_GT(material.scale_m, 0.0F);
      EXPECT_NE(material.base, previous);
      previous = material.base;
    }
  }
}

TEST(Albedo, OfALabelShowsBothColoursUpAPackage) {
  const Material label{.base = Colour::Zero(),
                       .second = Colour::Ones(),
                       .pattern = Pattern::kLabel,
                       .scale_m = 0.004F};
  int num_base = 0;
  int num_second = 0;
  for (int z = 0; z < 200; ++z) {
    for (int y = -20; y < 20; ++y) {
      const Vector3f at(0.03F, 0.001F * static_cast<float>(y), 0.001F * static_cast<float>(z));
      num_base += Albedo(label, at).x() < 0.1F ? 1 : 0;
      num_second += Albedo(label, at).x() > 0.8F ? 1 : 0;
    }
  }
  EXPECT_GT(num_base, 800);
  EXPECT_GT(num_second, 800);
}

TEST(DrawMetal, IsGrayAndMirrors) {
  Rng rng = Rng::Stream(1, "metal");
  const Material metal = DrawMetal(rng);
  EXPECT_EQ(metal.base.x(), metal.base.z());
  EXPECT_FLOAT_EQ(metal.specular, 0.35F);
  EXPECT_TRUE(
      Painted(Colour(0.5F, 0.4F, 0.3F), 0.1F).second.isApprox(Colour(0.46F, 0.368F, 0.276F)));
}

TEST(Clear, LetsMostLightThroughAndOthersNone) {
  EXPECT_GT(Clear(Colour::Ones()).transmission, 0.9F);
  EXPECT_EQ(Material{}.transmission, 0.0F);
  EXPECT_EQ(Painted(Colour::Ones(), 0.04F).transmission, 0.0F);
}

}  // namespace
}  // namespace handcraft::synthetic
