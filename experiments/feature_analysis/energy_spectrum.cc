// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/energy_spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "trainers/pca/pca.h"

namespace handcraft::experiments {
namespace {

using features::Energy;
using features::FeatureSpec;
using features::Filter;

constexpr double kPrintedOverOurs = 2000.0;  // the divisor of the edge masks (filter_bank.h)

bool IsEdge(Filter filter) { return filter >= Filter::kEdge0 && filter <= Filter::kEdge150; }

std::size_t FilterOf(std::size_t feature, const FeatureSpec& spec) {
  return feature % spec.filters.size();
}

std::size_t PositionOf(std::size_t feature, const FeatureSpec& spec) {
  return feature / spec.filters.size();
}

// What each feature is divided by.
std::vector<double> ScaleOf(const Scatter& scatter,
                            const FeatureSpec& spec,
                            FeatureScaling scaling) {
  if (scaling == FeatureScaling::kStandard) return pca::StandardDeviations(scatter);
  std::vector<double> scale(scatter.num_features, 1.0);
  if (scaling == FeatureScaling::kRaw) return scale;
  const double factor = std::pow(kPrintedOverOurs, spec.energy == Energy::kSquare ? 2.0 : 1.0);
  for (std::size_t j = 0; j < scale.size(); ++j) {
    if (IsEdge(spec.filters[FilterOf(j, spec)])) scale[j] = 1.0 / factor;
  }
  return scale;
}

// Of each feature, in the components that hold most of the energy.
std::vector<double> FeatureShares(const pca::Result& pca) {
  const std::size_t num_leading = pca.NumComponentsFor(kEnergyShares.back());
  std::vector<double> shares(pca.num_features, 0.0);
  double total = 0.0;
  for (std::size_t k = 0; k < num_leading; ++k) {
    total += pca.eigenvalues[k];
    for (std::size_t j = 0; j < pca.num_features; ++j) {
      shares[j] += pca.eigenvalues[k] * pca.Component(k)[j] * pca.Component(k)[j];
    }
  }
  for (double& share : shares) share /= total;
  return shares;
}

// Distance of a window pixel from the middle one, in rings.
std::size_t RingOf(std::size_t position, int window) {
  const int column = static_cast<int>(position) % window - window / 2;
  const int row = static_cast<int>(position) / window - window / 2;
  return static_cast<std::size_t>(std::max(std::abs(column), std::abs(row)));
}

std::vector<double> RingStrengths(std::span<const double> component, const FeatureSpec& spec) {
  const auto num_pixels = static_cast<std::size_t>(spec.window * spec.window);
  std::vector<double> peaks(num_pixels, 0.0);
  for (std::size_t j = 0; j < num_pixels * spec.filters.size(); ++j) {
    double& peak = peaks[PositionOf(j, spec)];
    peak = std::max(peak, std::abs(component[j]));
  }
  const double highest = *std::max_element(peaks.begin(), peaks.end());
  std::vector<double> strengths(static_cast<std::size_t>(spec.window / 2) + 1, 0.0);
  std::vector<double> counts(strengths.size(), 0.0);
  for (std::size_t position = 0; position < num_pixels; ++position) {
    const std::size_t ring = RingOf(position, spec.window);
    strengths[ring] += highest > 0.0 ? peaks[position] / highest : 0.0;
    counts[ring] += 1.0;
  }
  for (std::size_t ring = 0; ring < strengths.size(); ++ring) strengths[ring] /= counts[ring];
  return strengths;
}

}  // namespace

std::string_view NameOf(FeatureScaling scaling) noexcept {
  switch (scaling) {
    case FeatureScaling::kRaw:
      return "raw";
    case FeatureScaling::kPrintedMasks:
      return "printed_masks";
    case FeatureScaling::kStandard:
      return "standard";
  }
  return "unknown";
}

std::vector<FeatureScaling> ScalingsOf(const FeatureSpec& spec) {
  const bool knows_units = spec.energy != Energy::kLog;
  const bool has_edges = std::any_of(spec.filters.begin(), spec.filters.end(), IsEdge);
  if (!knows_units || !has_edges) return {FeatureScaling::kRaw, FeatureScaling::kStandard};
  return {FeatureScaling::kRaw, FeatureScaling::kPrintedMasks, FeatureScaling::kStandard};
}

EnergySpectrum ComputeEnergySpectrum(const Scatter& scatter,
                                     const FeatureSpec& spec,
                                     FeatureScaling scaling) {
  HC_CHECK(scatter.num_features == static_cast<std::size_t>(spec.NumFeatures()),
           scatter.num_features,
           spec.NumFeatures());
  const pca::Result pca = pca::PcaOfScatter(scatter, ScaleOf(scatter, spec, scaling));
  if (!(pca.TotalVariance() > 0.0)) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "no feature varies over the samples",
                 .remedy = "give pictures with something in them"});
  }
  EnergySpectrum spectrum{
      .scaling = scaling,
      .eigenvalues = pca.eigenvalues,
      .first_component = {pca.Component(0).begin(), pca.Component(0).end()},
      .filter_shares = std::vector<double>(spec.filters.size(), 0.0),
      .position_shares = std::vector<double>(scatter.num_features / spec.filters.size(), 0.0),
      .ring_strengths = RingStrengths(pca.Component(0), spec)};
  for (std::size_t i = 0; i < kEnergyShares.size(); ++i) {
    spectrum.num_components[i] = pca.NumComponentsFor(kEnergyShares[i]);
  }
  const std::vector<double> shares = FeatureShares(pca);
  for (std::size_t j = 0; j < shares.size(); ++j) {
    spectrum.filter_shares[FilterOf(j, spec)] += shares[j];
    spectrum.position_shares[PositionOf(j, spec)] += shares[j];
  }
  return spectrum;
}

void HypothesisRule::Validate() const {
  const std::string name = "HypothesisRule.";
  RequireOption(min_filter_share >= 0.0 && min_filter_share < 1.0,
                name + "min_filter_share",
                min_filter_share,
                "in [0, 1)");
  RequireOption(min_ring_strength >= 0.0 && min_ring_strength <= 1.0,
                name + "min_ring_strength",
                min_ring_strength,
                "in [0, 1]");
}

Hypotheses DeriveHypotheses(const EnergySpectrum& spectrum,
                            const FeatureSpec& spec,
                            const HypothesisRule& rule) {
  rule.Validate();
  Hypotheses derived{.filters = spec, .window = spec, .both = spec};
  derived.filters.filters.clear();
  for (std::size_t f = 0; f < spec.filters.size(); ++f) {
    if (spectrum.filter_shares[f] >= rule.min_filter_share) {
      derived.filters.filters.push_back(spec.filters[f]);
    }
  }
  if (derived.filters.filters.empty()) {  // all alike and many: the share of each is small
    derived.filters.filters = spec.filters;
  }
  std::size_t radius = spectrum.ring_strengths.size() - 1;
  while (radius > 0 && spectrum.ring_strengths[radius] < rule.min_ring_strength) --radius;
  derived.window.window = 2 * static_cast<int>(radius) + 1;
  derived.both.filters = derived.filters.filters;
  derived.both.window = derived.window.window;
  return derived;
}

}  // namespace handcraft::experiments
