// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/object_classes.h"

/// Cordless drills that stand on their battery, the chuck along +x; parameters [m] drawn from
/// ranges of their own, the middle of the box around them on the z axis. Graspable: the handle, and
/// the housing of the motor.
namespace handcraft::synthetic {

/// On a broad battery, the handle below the rear of the housing.
[[nodiscard]] Object DrawDrill(Rng& rng);
/// Smaller, T-shaped, the battery within the foot of the handle.
[[nodiscard]] Object DrawOtherDrill(Rng& rng);

}  // namespace handcraft::synthetic
