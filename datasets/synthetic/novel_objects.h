// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/object_classes.h"

/// The objects a model has never seen, as trained_objects.h has those it was trained on.
namespace handcraft::synthetic {

[[nodiscard]] Object DrawBottle(Rng& rng);         ///< graspable: the neck; stands or lies
[[nodiscard]] Object DrawCalculator(Rng& rng);     ///< the long sides with their borders
[[nodiscard]] Object DrawVerySmallCup(Rng& rng);   ///< ear and rim
[[nodiscard]] Object DrawHammer(Rng& rng);         ///< the handle
[[nodiscard]] Object DrawShampooBottle(Rng& rng);  ///< the middle of its height, and the cap
[[nodiscard]] Object DrawTape(Rng& rng);           ///< the whole ring; lies or stands

}  // namespace handcraft::synthetic
