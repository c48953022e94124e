// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/instruction_set.h"

#include <array>
#include <cstddef>

namespace handcraft::features {
namespace {

struct SetList {
  std::array<InstructionSet, 5> sets{};
  std::size_t count = 0;
  void Add(InstructionSet set) noexcept { sets[count++] = set; }
};

#if defined(__x86_64__)
// The compiler's support code also asks whether the operating system saves the wide registers.
// Every processor with AVX2 and FMA has the half-precision conversions that its code may use too.
SetList Detect() noexcept {
  SetList list;
  list.Add(InstructionSet::kBaseline);
  const bool has_sse4 = __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("sse4.2") &&
                        __builtin_cpu_supports("popcnt") && __builtin_cpu_supports("pclmul") &&
                        __builtin_cpu_supports("aes");
  const bool has_avx2 = has_sse4 && __builtin_cpu_supports("avx2") &&
                        __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                        __builtin_cpu_supports("bmi2");
  const bool has_avx512 = has_avx2 && __builtin_cpu_supports("avx512f") &&
                          __builtin_cpu_supports("avx512vl") &&
                          __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  if (has_sse4) list.Add(InstructionSet::kSse4);
  if (has_avx2) list.Add(InstructionSet::kAvx2);
  if (has_avx512) list.Add(InstructionSet::kAvx512);
  return list;
}
#elif defined(__aarch64__)
SetList Detect() noexcept {
  SetList list;
  list.Add(InstructionSet::kNeon);
  return list;
}
#else
SetList Detect() noexcept {
  SetList list;
  list.Add(InstructionSet::kBaseline);
  return list;
}
#endif

}  // namespace

std::string_view NameOf(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::kBaseline:
      return "baseline";
    case InstructionSet::kSse4:
      return "sse4";
    case InstructionSet::kNeon:
      return "neon";
    case InstructionSet::kAvx2:
      return "avx2";
    case InstructionSet::kAvx512:
      return "avx512";
  }
  return "unknown";
}

std::span<const InstructionSet> SupportedInstructionSets() noexcept {
  static const SetList list = Detect();
  return {list.sets.data(), list.count};
}

}  // namespace handcraft::features
