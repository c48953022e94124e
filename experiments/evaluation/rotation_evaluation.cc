// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/rotation_evaluation.h"

#include <algorithm>
#include <cmath>

#include "lib/core/check.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

using datasets::ObjectView;
using features::ViewDescription;

constexpr double kToleranceDeg = 0.01;

double AngleOf(const datasets::ViewSet& set, std::size_t index) {
  const ObjectView& view = set.items[index];
  if (view.angle_deg) return *view.angle_deg;
  throw Error({.path = (set.root / view.image).string(),
               .reason = "the view has no angle_deg",
               .remedy = "give views whose turn about z is known"});
}

// Degrees between two angles, in [0, 180].
double Apart(double a_deg, double b_deg) { return std::fabs(std::remainder(a_deg - b_deg, 360.0)); }

// Views of one class without one of them.
struct OtherViews {
  std::vector<double> normals = {};
  std::vector<double> moments = {};
  std::vector<double> angles_deg = {};

  void Add(const ViewDescription& view, double angle_deg) {
    normals.insert(normals.end(), view.normal.begin(), view.normal.end());
    moments.insert(moments.end(), view.moments.begin(), view.moments.end());
    angles_deg.push_back(angle_deg);
  }
  [[nodiscard]] double Nearest(const ViewDescription& view,
                               const features::RotationRule& rule) const {
    const features::HalvesMoments scales = features::MomentScales(moments);
    return angles_deg[features::NearestView(view, {normals, moments, scales}, rule)];
  }
  // Degrees from an angle to the nearest view.
  [[nodiscard]] double LeastApart(double angle_deg) const {
    double least = 360.0;
    for (const double other_deg : angles_deg) least = std::min(least, Apart(other_deg, angle_deg));
    return least;
  }
};

RotationCounts& CountsOf(std::vector<RotationCounts>& all,
                         const std::string& name,
                         const std::string& symmetry) {
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const RotationCounts& counts) { return counts.name == name; });
  if (found != all.end()) return *found;
  return all.emplace_back(RotationCounts{.name = name, .symmetry = symmetry});
}

bool IsFound(const OtherViews& others, double found_deg, double actual_deg, bool half_turn) {
  if (Apart(found_deg, actual_deg) <= others.LeastApart(actual_deg) + kToleranceDeg) return true;
  // The opposite view itself may be there; its neighbours are as near as those of the actual one.
  return half_turn &&
         Apart(found_deg, actual_deg + 180.0) <= others.LeastApart(actual_deg) + kToleranceDeg;
}

void Add(RotationCounts& counts, double turn_deg, bool is_found) {
  const double positive = turn_deg < 0.0 ? turn_deg + 360.0 : turn_deg;
  ++counts.histogram[static_cast<std::size_t>(std::lround(positive / 10.0)) % 36];
  ++counts.num_views;
  counts.num_found += is_found ? 1 : 0;
}

}  // namespace

RotationEvaluation EvaluateRotation(const datasets::ViewSet& set,
                                    std::span<const ViewDescription> descriptions,
                                    const features::RotationRule& rule) {
  HC_CHECK(descriptions.size() == set.items.size(), descriptions.size(), set.items.size());
  RotationEvaluation evaluation;
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    const ObjectView& view = set.items[i];
    if (view.symmetry == "round") continue;
    const double actual_deg = AngleOf(set, i);
    OtherViews others;
    for (std::size_t j = 0; j < set.items.size(); ++j) {
      if (j == i || set.items[j].object_class != view.object_class) continue;
      others.Add(descriptions[j], AngleOf(set, j));
    }
    if (others.angles_deg.empty()) {
      throw Error({.path = (set.root / view.image).string(),
                   .reason = "class " + view.object_class + " has no other view"});
    }
    const double found_deg = others.Nearest(descriptions[i], rule);
    const std::string symmetry = view.symmetry.empty() ? "none" : view.symmetry;
    const double turn_deg = std::remainder(found_deg - actual_deg, 360.0);
    const bool is_found = IsFound(others, found_deg, actual_deg, symmetry == "half_turn");
    Add(CountsOf(evaluation.classes, view.object_class, symmetry), turn_deg, is_found);
    Add(CountsOf(evaluation.symmetries, symmetry, symmetry), turn_deg, is_found);
  }
  return evaluation;
}

}  // namespace handcraft::experiments
