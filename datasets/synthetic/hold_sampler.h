// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>

#include "datasets/synthetic/demonstrator.h"

namespace handcraft::synthetic {

/// What two hands need to hold one object at once.
struct HoldRules {
  float least_height_m = 0.05F;  ///< of both grasp centres above the table (Eq. 5.1)
  int num_tries = 5000;          ///< pairs to look at before there is none; 1 ... 10⁶

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Poses of the right and the left hand, in the base frame.
struct ShownHold {
  ShownGrasp right;
  ShownGrasp left;
};

/// Why a pair of poses is no hold.
enum class HoldFault { kNone, kNearTable, kHandsMeet };

/// Whether both hands can hold the object in turn: their centres are high enough, the closed right
/// hand stays clear of the left one while that closes, and the closed left hand of the right one
/// while that opens. That either hand alone holds the object and stays clear of it is for
/// GraspCheck to say.
[[nodiscard]] HoldFault CheckHold(const ShownHold& hold,
                                  const Gripper& gripper,
                                  const HoldRules& rules);

/// How many pairs came to what, by HoldFault, and how many single poses.
struct HoldCounts {
  std::array<std::size_t, 3> by_fault{};
  GraspCounts poses;

  void Add(HoldFault fault) { ++by_fault[static_cast<std::size_t>(fault)]; }
  void Add(const HoldCounts& other);
  [[nodiscard]] std::size_t operator[](HoldFault fault) const {
    return by_fault[static_cast<std::size_t>(fault)];
  }
};

/// Draws pairs of shown poses, one of each demonstrator, until one is a hold: the holds by which an
/// object is passed from hand to hand (dissertation, section 5.2). Throws Error(kNoResult) when
/// there is none in num_tries pairs. Same state of the generator, same hold.
[[nodiscard]] ShownHold DrawHold(const Demonstrator& right,
                                 const Demonstrator& left,
                                 const Gripper& gripper,
                                 const HoldRules& rules,
                                 Rng& rng,
                                 HoldCounts& counts);

}  // namespace handcraft::synthetic
