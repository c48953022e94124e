// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include "lib/robot/serial_chain.h"

namespace handcraft::robot {

/// Weight of a turn against a shift in what is made small [m]: 1 rad counts like 0.1 m.
inline constexpr double kRotationLength_m = 0.1;

/// position² + (kRotationLength_m · rotation)² [m²].
[[nodiscard]] double SquaredError(const PoseError& error) noexcept;

/// Moves joint values, which start within the limits, to a local minimum of SquaredError between
/// the tip and `base_from_tip`, and returns the error left. Levenberg and Marquardt's steps,
/// projected on the limits: joints that lean against one are held. Quadratic when the pose is
/// reached, so a reached pose ends near rounding (1e-15). At most 200 steps. Allocates nothing;
/// thread-safe.
/// Source: Nocedal and Wright, Numerical Optimization, 2006, sections 10.3 and 16.7.
PoseError MoveToNearest(const SerialChain& chain,
                        const Pose& base_from_tip,
                        std::span<double> joints) noexcept;

}  // namespace handcraft::robot
