// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_features.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lib/features/feature_oracle.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/matrix_matchers.h"

namespace handcraft::features {
namespace {

using features::testing::MakePicture;
using features::testing::OracleFeatures;
using handcraft::testing::AreClose;

std::vector<float> FeaturesAt(const PixelFeatures& picture, int u, int v) {
  std::vector<float> values(static_cast<std::size_t>(picture.spec().NumFeatures()));
  picture.Gather(u, v, values);
  return values;
}

// A step of 0 | 255 between columns 3 and 4: the 0° mask sees 5 rows × 2 columns of weight
// 100/2000.
TEST(PixelFeatures, GivesTheEnergyOfAStepByHand) {
  std::vector<std::uint8_t> pixels(8 * 8, 0);
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = i % 8 >= 4 ? 255 : 0;
  const PixelFeatures features({pixels.data(), 8, 8, 8, PixelFormat::kGray8},
                               ParseFeatureSpec("filters=edge_0+edge_90+laws_LL,window=1"));
  const auto at_step = FeaturesAt(features, 4, 4);  // right of the step
  EXPECT_NEAR(at_step[0], 0.25, 1e-6);              // 5 rows of 0 0 · 1 1: (5 · 200 / 2000)²
  EXPECT_NEAR(at_step[1], 0.0, 1e-12);
  EXPECT_NEAR(at_step[2], 144.0, 1e-4);  // (3/4 · 16)²
  EXPECT_NEAR(FeaturesAt(features, 0, 4)[0], 0.0, 1e-12);
}

struct OracleCase {
  const char* spec;
  int width;
  int height;
};

class PixelFeaturesOracle : public ::testing::TestWithParam<OracleCase> {};

INSTANTIATE_TEST_SUITE_P(Pictures,
                         PixelFeaturesOracle,
                         ::testing::Values(OracleCase{"all500", 40, 30},
                                           OracleCase{"all500,energy=abs", 21, 19},
                                           OracleCase{"all500,energy=log", 21, 19},
                                           OracleCase{"saxena459", 47, 31},
                                           OracleCase{"saxena459,energy=log,scales=2+16", 140, 9},
                                           OracleCase{"edges54", 1, 1},
                                           OracleCase{"all500", 4, 4},
                                           OracleCase{"window180", 300, 3}));

// Tolerance: a response is a sum of weights up to 36 on numbers up to 1 in single precision, so it
// is good to about 4e-6, and its square to 8e-6 of a response of 1.
TEST_P(PixelFeaturesOracle, EqualsTheNaiveDoubleOne) {
  const OracleCase& c = GetParam();
  const FeatureSpec spec = ParseFeatureSpec(c.spec);
  const auto picture = MakePicture(c.width, c.height, PixelFormat::kBgr8, 3, 5);
  for (const InstructionSet set : SupportedInstructionSets()) {
    const PixelFeatures features(picture.raw, spec, set);
    Rng rng(4);
    for (int i = 0; i < 12; ++i) {
      const int u = i == 0 ? 0
                    : i == 1
                        ? c.width - 1
                        : static_cast<int>(rng.UniformInt(static_cast<std::uint64_t>(c.width)));
      const int v = i == 0 ? 0
                    : i == 1
                        ? c.height - 1
                        : static_cast<int>(rng.UniformInt(static_cast<std::uint64_t>(c.height)));
      // A logarithm near its floor magnifies the square's rounding by 1 / 1e-5.
      const double tolerance = spec.energy == Energy::kLog ? 2e-4 : 1e-5;
      EXPECT_TRUE(
          AreClose(FeaturesAt(features, u, v), OracleFeatures(picture.raw, spec, u, v), tolerance))
          << c.spec << " " << NameOf(set) << " at " << u << ", " << v;
    }
  }
}

TEST(PixelFeatures, FusedSetsGiveTheSameBits) {
  const auto picture = MakePicture(150, 20, PixelFormat::kRgb8, 5);
  const FeatureSpec spec = ParseFeatureSpec("saxena459,energy=log");
  const PixelFeatures best(picture.raw, spec);
  for (const InstructionSet set : SupportedInstructionSets()) {
    if (set < InstructionSet::kNeon) continue;
    const PixelFeatures other(picture.raw, spec, set);
    for (int u = 0; u < 150; u += 7) EXPECT_EQ(FeaturesAt(best, u, 11), FeaturesAt(other, u, 11));
  }
}

// Adding a constant to the picture leaves every derivative filter as it was.
TEST(PixelFeatures, DerivativesIgnoreBrightness) {
  auto picture = MakePicture(40, 40, PixelFormat::kGray8, 6);
  for (auto& byte : picture.bytes) byte = static_cast<std::uint8_t>(byte / 2);
  const FeatureSpec spec = ParseFeatureSpec("filters=edges+sobel+laplacian,window=3");
  const auto before = FeaturesAt(PixelFeatures(picture.raw, spec), 20, 20);
  for (auto& byte : picture.bytes) byte = static_cast<std::uint8_t>(byte + 100);
  EXPECT_TRUE(AreClose(FeaturesAt(PixelFeatures(picture.raw, spec), 20, 20), before, 1e-5));
}

// Turning the picture by 90° swaps the horizontal and vertical edge filters.
TEST(PixelFeatures, QuarterTurnSwapsTheEdgeDirections) {
  const auto picture = MakePicture(31, 31, PixelFormat::kGray8, 7);
  std::vector<std::uint8_t> turned(31 * 31);
  for (std::size_t y = 0; y < 31; ++y) {
    for (std::size_t x = 0; x < 31; ++x) turned[(30 - x) * 31 + y] = picture.bytes[y * 31 + x];
  }
  const RawImage turned_raw{turned.data(), 31, 31, 31, PixelFormat::kGray8};
  const auto of = [](const RawImage& raw, const char* filters) {
    return PixelFeatures(raw, ParseFeatureSpec("filters=" + std::string(filters) + ",window=1"));
  };
  const auto before = FeaturesAt(of(picture.raw, "edge_0+edge_30+edge_60"), 12, 20);
  const auto after = FeaturesAt(of(turned_raw, "edge_90+edge_120+edge_150"), 20, 30 - 12);
  EXPECT_TRUE(AreClose(after, before, 1e-5));
}

TEST(PixelFeatures, EnergyPlaneHoldsTheSameNumbers) {
  const auto picture = MakePicture(20, 10, PixelFormat::kGray8, 8);
  const PixelFeatures features(picture.raw, ParseFeatureSpec("filters=edges,window=1"));
  EXPECT_EQ(features.EnergyPlane(2).At(7, 3), FeaturesAt(features, 7, 3)[2]);
}

TEST(PixelFeatures, RefusesCallersMistakes) {
  const auto gray = MakePicture(5, 5, PixelFormat::kGray8, 1);
  EXPECT_THROW(PixelFeatures(gray.raw, ParseFeatureSpec("saxena459")), std::logic_error);
  EXPECT_THROWS_MESSAGE(
      PixelFeatures(gray.raw, FeatureSpec{}), std::logic_error, ::testing::HasSubstr("no filters"));
  EXPECT_THROW(PixelFeatures(RawImage{}, ParseFeatureSpec("all500")), std::logic_error);
  const PixelFeatures features(gray.raw, ParseFeatureSpec("edges54"));
  std::vector<float> values(54);
  EXPECT_THROW(features.Gather(5, 0, values), std::logic_error);
  std::vector<float> too_few(53);
  EXPECT_THROW(features.Gather(0, 0, too_few), std::logic_error);
}

}  // namespace
}  // namespace handcraft::features
