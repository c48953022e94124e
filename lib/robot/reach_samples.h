// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "lib/robot/spherical_arm.h"

namespace handcraft::robot {

/// For which θ₃ the shoulder reaches, with one elbow angle: where the two θ₂ of the sweep
/// (sweep_kernel.h) exist, u_x² + u_y² ≥ k². There are at most two intervals; near a singular
/// shoulder they shrink to points, which no fixed step meets. Returns, for each, its ends, its
/// middle, and points between them, as angles in [−π, π]. `wrist_in_third` and `wrist_in_first` as
/// in SweepJob. Thread-safe.
[[nodiscard]] std::vector<double> ReachSamples(const SphericalJoint& shoulder,
                                               const Vector3& wrist_in_third,
                                               const Vector3& wrist_in_first);

}  // namespace handcraft::robot
