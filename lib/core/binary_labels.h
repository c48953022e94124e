// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handcraft {

/// How many labels are 1. Throws Error(kBadInput) unless every label is 0 or 1 (row named, from 0)
/// and both occur.
[[nodiscard]] std::size_t CountPositive(std::span<const std::uint8_t> labels);

}  // namespace handcraft
