// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/hold_sampler.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

GripperBoxes Closed(const ShownGrasp& shown, const Gripper& gripper) {
  return ClosedBoxes(gripper, shown.contacts, shown.base_from_grasp.ToIsometry().cast<float>());
}

GripperBoxes Swept(const ShownGrasp& shown, const Gripper& gripper) {
  return SweptBoxes(gripper, shown.contacts, shown.base_from_grasp.ToIsometry().cast<float>());
}

}  // namespace

void HoldCounts::Add(const HoldCounts& other) {
  for (std::size_t i = 0; i < by_fault.size(); ++i) by_fault[i] += other.by_fault[i];
  poses.Add(other.poses);
}

void HoldRules::Validate() const {
  RequireOption(least_height_m >= 0.0F && least_height_m <= 1.0F,
                "HoldRules.least_height_m",
                least_height_m,
                "from 0 to 1");
  RequireOption(num_tries >= 1 && num_tries <= 1000000,
                "HoldRules.num_tries",
                num_tries,
                "from 1 to 1000000");
}

HoldFault CheckHold(const ShownHold& hold, const Gripper& gripper, const HoldRules& rules) {
  const auto is_low = [&](const ShownGrasp& shown) {
    return shown.base_from_grasp.position_m.z() < static_cast<double>(rules.least_height_m);
  };
  if (is_low(hold.right) || is_low(hold.left)) return HoldFault::kNearTable;
  const bool meet = Collide(Closed(hold.right, gripper), Swept(hold.left, gripper)) ||
                    Collide(Swept(hold.right, gripper), Closed(hold.left, gripper));
  return meet ? HoldFault::kHandsMeet : HoldFault::kNone;
}

ShownHold DrawHold(const Demonstrator& right,
                   const Demonstrator& left,
                   const Gripper& gripper,
                   const HoldRules& rules,
                   Rng& rng,
                   HoldCounts& counts) {
  rules.Validate();
  for (int tries = 0; tries < rules.num_tries; ++tries) {
    const ShownGrasp of_right = right.Show(rng, counts.poses);
    ShownHold hold{.right = of_right, .left = left.Show(rng, counts.poses)};
    const HoldFault fault = CheckHold(hold, gripper, rules);
    counts.Add(fault);
    if (fault == HoldFault::kNone) return hold;
  }
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "no way for two hands to hold the object at once in " +
                         std::to_string(rules.num_tries) + " pairs of poses",
               .remedy = "it may be too small for both"});
}

}  // namespace handcraft::synthetic
