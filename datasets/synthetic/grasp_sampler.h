// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/synthetic/grasp_check.h"
#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// A pose at which the hand holds an object.
struct Grasp {
  Eigen::Isometry3f object_from_grasp = Eigen::Isometry3f::Identity();
  ContactPlaces contacts;
};

/// How many poses broke which rule; at kNone how many broke none.
struct GraspCounts {
  std::array<std::size_t, kNumGraspFaults> by_fault{};

  void Add(GraspFault fault) { ++by_fault[static_cast<std::size_t>(fault)]; }
  void Add(const GraspCounts& other);
  [[nodiscard]] std::size_t operator[](GraspFault fault) const {
    return by_fault[static_cast<std::size_t>(fault)];
  }
  [[nodiscard]] std::size_t Total() const;
  /// "of 120 poses 80 too wide, 30 slips, 10 valid": what is not nought, the most frequent first.
  [[nodiscard]] std::string ToText() const;
};

struct GraspSamplerOptions {
  int num_tries = 10000;   ///< poses to look at, at most; 1 ... 10⁷
  int most_grasps = 1000;  ///< enough; 1 ... 10⁶
  int num_approaches = 4;  ///< turns about the closing axis for each pair of contacts; 1 ... 360

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Throws Error(kNoResult) when there is no grasp, saying what came of the poses that were looked
/// at: "the hand cannot hold the NAME: of 120 poses …".
void RequireGrasps(const std::vector<Grasp>& grasps,
                   std::string_view name,
                   const GraspCounts& counts);

/// Poses all over an object at which the hand holds it (GraspCheck::Close finds no fault), out of
/// any arm's reach or not.
///
/// A point of the surface is drawn (each area alike) and a line into the object (within its
/// friction cone). The other contact is where the line leaves the object first or, every second
/// time, last within the hand's opening: a part beside others may be held, and all of them. The
/// grasp centre is the middle of the two; the approach axis is turned about the line, evenly from a
/// drawn angle; fingers and thumb take either side. Every pose is then checked. `counts` gains what
/// came of each. The result is empty when nothing can be held. Same state of the generator, same
/// grasps. The idea is that of antipodal sampling (e.g. ten Pas and Platt, "Using geometry to
/// detect grasp poses in 3D point clouds", 2015), on the true mesh.
[[nodiscard]] std::vector<Grasp> SampleGrasps(const GraspCheck& check,
                                              const GraspSamplerOptions& options,
                                              Rng& rng,
                                              GraspCounts& counts);

}  // namespace handcraft::synthetic
