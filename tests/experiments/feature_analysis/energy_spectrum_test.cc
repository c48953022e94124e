// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/energy_spectrum.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using features::Filter;
using features::ParseFeatureSpec;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The scatter of features that vary independently with these standard deviations.
Scatter Independent(const std::vector<double>& deviations) {
  const std::size_t p = deviations.size();
  Scatter scatter{.num_features = p,
                  .num_rows = {11},
                  .means = std::vector<double>(p, 0.0),
                  .products = std::vector<double>(p * p, 0.0)};
  for (std::size_t j = 0; j < p; ++j) {
    scatter.products[j * p + j] = 10.0 * deviations[j] * deviations[j];
  }
  return scatter;
}

double Sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(EnergySpectrum, OfTwoFiltersByHand) {
  const features::FeatureSpec spec = ParseFeatureSpec("filters=laws_LL+edge_0,window=1,scales=3");
  const EnergySpectrum spectrum =
      ComputeEnergySpectrum(Independent({3.0, 1.0, 2.0, 2.0}), spec, FeatureScaling::kRaw);
  EXPECT_EQ(spectrum.num_components[0], 3U);  // 9 + 4 + 4 of 18
  EXPECT_EQ(spectrum.num_components[2], 4U);
  EXPECT_NEAR(spectrum.filter_shares[0], 13.0 / 18.0, 1e-14);
  EXPECT_NEAR(spectrum.filter_shares[1], 5.0 / 18.0, 1e-14);
  EXPECT_NEAR(spectrum.position_shares[0], 10.0 / 18.0, 1e-14);
  EXPECT_NEAR(spectrum.position_shares[1], 8.0 / 18.0, 1e-14);
  EXPECT_THAT(spectrum.ring_strengths, ElementsAre(1.0));
}

TEST(EnergySpectrum, CountsLeadingComponentsAlone) {
  const features::FeatureSpec spec = ParseFeatureSpec("filters=laws_LL+edge_0,window=1");
  const EnergySpectrum spectrum =
      ComputeEnergySpectrum(Independent({100.0, 1.0}), spec, FeatureScaling::kRaw);
  EXPECT_EQ(spectrum.num_components[2], 1U);
  EXPECT_NEAR(spectrum.filter_shares[0], 1.0, 1e-14);
  EXPECT_NEAR(spectrum.filter_shares[1], 0.0, 1e-14);
}

TEST(EnergySpectrum, PrintedMasksMakeEdgesLead) {
  const features::FeatureSpec spec = ParseFeatureSpec("filters=laws_LL+edge_0,window=1");
  const Scatter scatter = Independent({4e6, 1.0});  // the square of 2000
  const auto share = [&](const features::FeatureSpec& s) {
    return ComputeEnergySpectrum(scatter, s, FeatureScaling::kPrintedMasks).filter_shares[1];
  };
  EXPECT_NEAR(share(spec), 0.5, 1e-12);
  features::FeatureSpec absolute = spec;
  absolute.energy = features::Energy::kAbs;  // only 2000 times as large
  EXPECT_LT(share(absolute), 0.01);
}

TEST(EnergySpectrum, StandardScalingTakesUnitsAway) {
  const features::FeatureSpec spec = ParseFeatureSpec("filters=laws_LL+edge_0,window=1");
  const EnergySpectrum spectrum =
      ComputeEnergySpectrum(Independent({1e5, 1e-5}), spec, FeatureScaling::kStandard);
  EXPECT_NEAR(spectrum.filter_shares[0], 0.5, 1e-12);
  EXPECT_NEAR(spectrum.eigenvalues[0], 1.0, 1e-12);
}

// A pattern over a 5×5 window whose rings have the heights 1, 0.8 and 0.6: rank one.
TEST(EnergySpectrum, MeasuresThePeaksOfRings) {
  const features::FeatureSpec spec = ParseFeatureSpec("filters=edge_0+edge_30,window=5");
  std::vector<double> pattern;
  for (int row = -2; row <= 2; ++row) {
    for (int column = -2; column <= 2; ++column) {
      const int ring = std::max(std::abs(row), std::abs(column));
      pattern.push_back(1.0 - 0.2 * ring);
      pattern.push_back(-0.5 * (1.0 - 0.2 * ring));
    }
  }
  Scatter scatter = Independent(std::vector<double>(50, 0.0));
  for (std::size_t i = 0; i < 50; ++i) {
    for (std::size_t j = 0; j < 50; ++j) scatter.products[i * 50 + j] = pattern[i] * pattern[j];
  }
  const EnergySpectrum spectrum = ComputeEnergySpectrum(scatter, spec, FeatureScaling::kRaw);
  EXPECT_NEAR(spectrum.ring_strengths[0], 1.0, 1e-12);
  EXPECT_NEAR(spectrum.ring_strengths[1], 0.8, 1e-12);
  EXPECT_NEAR(spectrum.ring_strengths[2], 0.6, 1e-12);
  EXPECT_NEAR(spectrum.filter_shares[0], 0.8, 1e-12);  // 1 to 0.25
  EXPECT_NEAR(Sum(spectrum.filter_shares), 1.0, 1e-12);
  EXPECT_NEAR(Sum(spectrum.position_shares), 1.0, 1e-12);

  const Hypotheses derived = DeriveHypotheses(spectrum, spec);
  EXPECT_EQ(derived.filters, spec);
  EXPECT_EQ(derived.window.window, 3);
  EXPECT_EQ(derived.both.NumFeatures(), 18);
  EXPECT_EQ(DeriveHypotheses(spectrum, spec, {.min_ring_strength = 0.9}).window.window, 1);
  EXPECT_EQ(DeriveHypotheses(spectrum, spec, {.min_ring_strength = 0.5}).window.window, 5);
  const Hypotheses strict = DeriveHypotheses(spectrum, spec, {.min_filter_share = 0.3});
  EXPECT_THAT(strict.both.filters, ElementsAre(Filter::kEdge0));
  EXPECT_EQ(strict.both.window, 3);
  EXPECT_EQ(DeriveHypotheses(spectrum, spec, {.min_filter_share = 0.9}).filters, spec);
}

TEST(EnergySpectrum, ScalingsAreThoseThatDiffer) {
  EXPECT_EQ(ScalingsOf(ParseFeatureSpec("all500")).size(), 3U);
  EXPECT_EQ(ScalingsOf(ParseFeatureSpec("all500,energy=log")).size(), 2U);
  EXPECT_EQ(ScalingsOf(ParseFeatureSpec("filters=laws,window=3")).size(), 2U);
}

TEST(EnergySpectrum, RefusesWhatDoesNotVaryAndWhatDoesNotFit) {
  const features::FeatureSpec spec = ParseFeatureSpec("filters=edge_0,window=1");
  for (const FeatureScaling scaling : ScalingsOf(spec)) {
    EXPECT_THROWS_MESSAGE(ComputeEnergySpectrum(Independent({0.0}), spec, scaling),
                          Error,
                          HasSubstr("no feature varies"));
  }
  EXPECT_THROW(
      static_cast<void>(ComputeEnergySpectrum(Independent({1.0, 2.0}), spec, FeatureScaling::kRaw)),
      std::logic_error);
}

TEST(HypothesisRule, NamesFieldValueAndRule) {
  EXPECT_THROWS_MESSAGE(HypothesisRule{.min_filter_share = 1.0}.Validate(),
                        Error,
                        HasSubstr("min_filter_share is 1; it must be in [0, 1)"));
  EXPECT_THROWS_MESSAGE(
      HypothesisRule{.min_ring_strength = 2.0}.Validate(), Error, HasSubstr("min_ring_strength"));
}

}  // namespace
}  // namespace handcraft::experiments
