// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "lib/perception/cloud_view.h"

namespace handcraft::perception {

struct CloudOutlierOptions {
  float step = 1.5F;        ///< Step of Eqs. (3.3) and (3.4), in interquartile ranges; in [0, 100]
  int max_samples = 16384;  ///< values that quartiles are taken from; ≥ 4

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("step", step);
    visit("max_samples", max_samples);
  }
};

/// The values that are no outliers: lower ≤ x ≤ upper.
struct Fence {
  float lower = 0.0F;
  float upper = 0.0F;

  bool operator==(const Fence&) const = default;
};

/// ε_L = Q1 − step · (Q3 − Q1) and ε_U = Q3 + step · (Q3 − Q1). A quartile of n values is their
/// order statistic number q · (n − 1), q = ¼ or ¾, interpolated between its neighbours. Of more
/// than max_samples values, every k-th is taken, k = ⌈n / max_samples⌉. {0, 0} for no values.
/// Source: dissertation Eqs. (3.3), (3.4); J. Laurikkala et al., "Informal identification of
/// outliers in medical data", 2000.
[[nodiscard]] Fence FenceOf(std::span<const float> values, const CloudOutlierOptions& options);

/// Removes the points beyond the fence of any axis. The three fences come from the same points:
/// the order of the axes changes nothing. The options must be valid.
void RemoveOutliers(PixelPoints& points, const CloudOutlierOptions& options);

}  // namespace handcraft::perception
