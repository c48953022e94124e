// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/object_classes.h"

/// Objects whose grasps the robot was not taught (dissertation, Figure 4.6), as taught_objects.h
/// has those it was; the other drill is in drills.h.
namespace handcraft::synthetic {

/// Stands on its short edge; graspable: the upper half.
[[nodiscard]] Object DrawDvdCase(Rng& rng);
/// Flat, with a wide cap; graspable: the middle of its height.
[[nodiscard]] Object DrawFlipTopBottle(Rng& rng);
/// Wider above, with a square handle; graspable: handle and rim.
[[nodiscard]] Object DrawTaperedMug(Rng& rng);
/// A slanted jug with a straight handle and a spout; graspable: the handle.
[[nodiscard]] Object DrawSlantedJug(Rng& rng);
/// A round bottle with rings about its body; graspable: the middle of its height.
[[nodiscard]] Object DrawWaterBottle(Rng& rng);
/// A cardboard cylinder; graspable: its side.
[[nodiscard]] Object DrawSaltContainer(Rng& rng);
/// A printed carton; graspable: the upper half of its sides.
[[nodiscard]] Object DrawRectangularBox(Rng& rng);

}  // namespace handcraft::synthetic
