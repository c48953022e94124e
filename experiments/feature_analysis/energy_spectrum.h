// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lib/features/feature_spec.h"
#include "lib/linear_algebra/scatter.h"

namespace handcraft::experiments {

/// In which units features enter the principal components. They decide which filters lead: a filter
/// whose numbers are written ten times as large has a hundred times the variance of its response.
enum class FeatureScaling : std::uint8_t {
  kRaw,           ///< as the features are computed
  kPrintedMasks,  ///< as raw, but with the edge masks as integers (±100), as they are printed:
                  ///< their responses are 2000 times as large
  kStandard,      ///< every feature divided by its standard deviation
};
[[nodiscard]] std::string_view NameOf(FeatureScaling scaling) noexcept;

/// The scalings that differ for a specification: logarithms of energies do not know the units, and
/// there may be no edge mask.
[[nodiscard]] std::vector<FeatureScaling> ScalingsOf(const features::FeatureSpec& spec);

/// The shares of energy whose number of components is counted; the last one bounds the leading
/// components.
inline constexpr std::array<double, 3> kEnergyShares = {0.90, 0.95, 0.99};

/// Where the energy (variance) of the features lies.
struct EnergySpectrum {
  FeatureScaling scaling = FeatureScaling::kRaw;
  std::vector<double> eigenvalues = {};         ///< descending
  std::vector<double> first_component = {};     ///< num_features, of length 1
  std::array<std::size_t, 3> num_components{};  ///< that hold kEnergyShares
  std::vector<double> filter_shares = {};  ///< of the leading components' energy; they add up to 1
  std::vector<double> position_shares =
      {};  ///< the same of the window's pixels, then of the scales
  std::vector<double> ring_strengths =
      {};  ///< by distance from the middle pixel, 0 … window/2: see below
};

/// Principal components of the features. With m the leading components (99 % of the energy), the
/// share of a set S of features (a filter's, or a window pixel's) is
///   Σ_{k ≤ m} λ_k Σ_{j ∈ S} e_kj² / Σ_{k ≤ m} λ_k;
/// the strength of a ring of pixels is the mean over its pixels of their largest |e_1j|, divided by
/// the largest of all: the height of the peaks in the dissertation's Figure 3.3.
/// Throws Error(kNoResult) when no feature varies; std::logic_error when `scatter`, of one group,
/// has another number of features. Source: dissertation section 3.2.1;
/// docs/methods/feature_analysis.md.
[[nodiscard]] EnergySpectrum ComputeEnergySpectrum(const Scatter& scatter,
                                                   const features::FeatureSpec& spec,
                                                   FeatureScaling scaling);

/// What is negligible.
struct HypothesisRule {
  double min_filter_share = 0.01;   ///< filters below this share are dropped, [0, 1)
  double min_ring_strength = 0.70;  ///< outer rings below this are dropped, [0, 1]; peaks 30 to 40
                                    ///< % lower are what the dissertation calls larger than needed

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// The dissertation's three ways to save features, as these data suggest them.
struct Hypotheses {
  features::FeatureSpec filters;  ///< 1: fewer filters
  features::FeatureSpec window;   ///< 2: a smaller window
  features::FeatureSpec both;     ///< 3
};
[[nodiscard]] Hypotheses DeriveHypotheses(const EnergySpectrum& spectrum,
                                          const features::FeatureSpec& spec,
                                          const HypothesisRule& rule = {});

}  // namespace handcraft::experiments
