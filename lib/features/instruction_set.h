// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace handcraft::features {

/// Instruction sets with a version of the vector code of their own. Those with a fused multiply-add
/// (NEON, AVX2, AVX-512) round every operation alike and give the same bits; baseline and SSE4 have
/// none and differ from them in the last bits.
enum class InstructionSet : std::uint8_t {
  kBaseline,  ///< plain C++: any processor
  kSse4,
  kNeon,
  kAvx2,
  kAvx512,
};

[[nodiscard]] std::string_view NameOf(InstructionSet set) noexcept;

/// Those that this program has code for and this processor can run, best last; never empty.
/// Thread-safe; asks the processor once.
[[nodiscard]] std::span<const InstructionSet> SupportedInstructionSets() noexcept;

}  // namespace handcraft::features
