// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/features/filter_bank.h"

namespace handcraft::features {

/// What is taken from a filter's energy E (squared response, see filter_bank.h).
enum class Energy : std::uint8_t {
  kSquare = 0,  ///< E, as in the dissertation
  kAbs = 1,     ///< √E: the absolute response, the gradient's length for two-component filters
  kLog = 2,     ///< ln(E + kLogEnergyOffset): for photographs, whose energies span many decades
};

inline constexpr float kLogEnergyOffset = 1e-5F;

/// Which numbers describe a pixel, and in which order.
///
/// The feature vector x of the pixel (u, v) holds, for every pixel of the window × window
/// neighbourhood in row-major order, the energies of `filters` in their order:
///   x[num_filters · (window · (dv + r) + (du + r)) + f],  r = (window − 1) / 2;
/// a neighbour outside the picture is replaced by the nearest pixel inside. Then follow, for each
/// entry s of `scales`, the energies of `filters` at the one pixel of the picture shrunk s-fold
/// (Saxena et al.; see pixel_features.h).
/// The dissertation's 500 features are all twenty intensity filters with window 5 and no scales.
struct FeatureSpec {
  std::vector<Filter> filters;  ///< distinct, at least one
  int window = 5;               ///< 1, 3 or 5 [px]
  Energy energy = Energy::kSquare;
  std::vector<int> scales;  ///< each 2…16, ascending; usually {} or {3, 9}

  [[nodiscard]] int NumFilters() const noexcept { return static_cast<int>(filters.size()); }
  [[nodiscard]] int NumFeatures() const noexcept {
    return NumFilters() * (window * window + static_cast<int>(scales.size()));
  }
  /// Whether a filter looks at Cb or Cr, so that gray pictures cannot be scored.
  [[nodiscard]] bool NeedsColour() const noexcept;

  bool operator==(const FeatureSpec&) const = default;
};

/// Reads a specification. Either a preset, or `key=value` pairs, or a preset followed by pairs that
/// change it, separated by commas:
///   all500 | edges150 | window180 | edges54 | saxena459
///   all500,energy=log
///   filters=edges+sobel1_5+laplacian,window=3,energy=abs,scales=3+9
/// `filters` takes filter names and the groups all (the twenty), laws, edges, sobel, chroma.
/// Throws Error(kUsage) that names the wrong word and lists what is allowed.
[[nodiscard]] FeatureSpec ParseFeatureSpec(std::string_view text);

/// The canonical text: every key, filters by name in order; ParseFeatureSpec(ToString(s)) == s.
[[nodiscard]] std::string ToString(const FeatureSpec& spec);

/// Empty when the specification is valid, else what is wrong with it. Used by the model reader,
/// which must not throw.
[[nodiscard]] std::string_view FaultOf(const FeatureSpec& spec) noexcept;

[[nodiscard]] std::string_view NameOf(Energy energy) noexcept;

/// Name of feature i: "edge_30@(-2,1)" (filter@(du,dv)) or "edge_30@1/3".
[[nodiscard]] std::string FeatureName(const FeatureSpec& spec, int index);

}  // namespace handcraft::features
