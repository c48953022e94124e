// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/object_classes.h"

/// The objects whose grasps the robot was taught (dissertation, Figure 4.2); the drill is in
/// drills.h. Each draws its parameters [m] from ranges of its own; what a hand would close around
/// is marked on the mesh. Standing; the front, a handle or else the broad side with the label,
/// faces +x. Same state of the generator, same object.
namespace handcraft::synthetic {

/// A tin with a rectangular, rounded section and a plastic lid; graspable: its sides.
[[nodiscard]] Object DrawCoffeeCan(Rng& rng);
/// Flat, with shoulders, coloured, labelled on both broad sides; graspable: the middle of its
/// sides.
[[nodiscard]] Object DrawMouthwashBottle(Rng& rng);
/// Bellied, with a round handle; graspable: handle and rim.
[[nodiscard]] Object DrawBelliedMug(Rng& rng);
/// A jug with a hole behind its handle; graspable: the handle.
[[nodiscard]] Object DrawDetergentBottle(Rng& rng);
/// A round bottle for lemonade; graspable: its waist.
[[nodiscard]] Object DrawPlasticBottle(Rng& rng);

}  // namespace handcraft::synthetic
