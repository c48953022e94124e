// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "experiments/metrics/binary_metrics.h"
#include "lib/features/object_rotation.h"

namespace handcraft::experiments {

/// How the turns of some views were found.
struct RotationCounts {
  std::string name;      ///< of a class, or a symmetry: "none", "half_turn"
  std::string symmetry;  ///< about z
  std::size_t num_views = 0;
  std::size_t num_found = 0;  ///< the nearest other view, or with half_turn the one opposite
  /// How far the view found is turned from the actual one: bin i holds (10 i ± 5) degrees.
  std::array<std::size_t, 36> histogram = {};

  /// Share found, with its Wilson interval: views are taken as independent.
  [[nodiscard]] Estimate Found() const { return WilsonInterval(num_found, num_views); }
};

struct RotationEvaluation {
  std::vector<RotationCounts> classes;     ///< in the set's order, without round objects
  std::vector<RotationCounts> symmetries;  ///< the same views by symmetry, in order of appearance
};

/// Figure 4.7: each view of a class is left out and the most similar of the others is looked for
/// (features::NearestView; scales of moments without the view). Found is one that no other view's
/// angle is nearer than (to 0.01 degrees, either side counts), or, when the object looks the same
/// after half a turn, one that is so near to the opposite angle. Objects that are round have no
/// turn and are left out; an unknown symmetry is none. `descriptions` are DescribeViews'. Throws
/// Error(kBadInput) for a view without an angle and for a class with fewer than two views.
/// Source: dissertation section 4.3.2.
[[nodiscard]] RotationEvaluation EvaluateRotation(
    const datasets::ViewSet& set,
    std::span<const features::ViewDescription> descriptions,
    const features::RotationRule& rule);

}  // namespace handcraft::experiments
