// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/object_classes.h"

/// The objects a model is trained on. Each draws its parameters [m] from ranges of its own; what a
/// person would take hold of is marked on the mesh. Same state of the generator, same object.
namespace handcraft::synthetic {

[[nodiscard]] Object DrawCerealBowl(Rng& rng);    ///< graspable: the rim
[[nodiscard]] Object DrawEraser(Rng& rng);        ///< the middle of its length
[[nodiscard]] Object DrawMartiniGlass(Rng& rng);  ///< the stem
[[nodiscard]] Object DrawMug(Rng& rng);           ///< handle and rim
[[nodiscard]] Object DrawStapler(Rng& rng);       ///< the middle of the arm
[[nodiscard]] Object DrawTeaCup(Rng& rng);        ///< handle and rim; a saucer beneath some
[[nodiscard]] Object DrawPencil(Rng& rng);        ///< the middle of its length

}  // namespace handcraft::synthetic
