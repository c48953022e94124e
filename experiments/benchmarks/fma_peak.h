// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "lib/features/instruction_set.h"

namespace handcraft::experiments {

/// Single-precision multiply-adds a second that one core reaches with nothing but multiply-adds on
/// registers of the given instruction set: the limit that a kernel's speed is compared with.
/// Measured for about 50 ms at the clock of the moment. NaN where this program has no such loop.
[[nodiscard]] double MeasureFmaPeak(features::InstructionSet set);

}  // namespace handcraft::experiments
