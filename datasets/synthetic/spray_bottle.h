// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/object_classes.h"

namespace handcraft::synthetic {

/// A bottle with a spray head (dissertation, section 5.3), its nozzle along +x; parameters [m]
/// drawn from ranges of its own. Graspable: neck and body below the head. Same state of the
/// generator, same object.
[[nodiscard]] Object DrawSprayBottle(Rng& rng);

}  // namespace handcraft::synthetic
