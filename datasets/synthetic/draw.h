// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/core/rng.h"

namespace handcraft::synthetic {

/// Uniform in [low, high).
[[nodiscard]] inline float Between(Rng& rng, float low, float high) {
  return low + (high - low) * static_cast<float>(rng.Uniform());
}

/// True with this probability.
[[nodiscard]] inline bool Chance(Rng& rng, double probability) {
  return rng.Uniform() < probability;
}

}  // namespace handcraft::synthetic
