// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/fma_peak.h"

#include <chrono>
#include <cstddef>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace handcraft::experiments {
namespace {

constexpr std::size_t kRounds = 2000000;
constexpr std::size_t kChains = 12;  // latency 4 or 5 times two units, and some

#if defined(__x86_64__)
// Twelve independent chains from a start the compiler cannot know; their sum is returned so that it
// keeps them.
__attribute__((target("avx2,fma"))) float RunAvx2(float start) {
  __m256 sums[kChains];
  for (auto& sum : sums) sum = _mm256_set1_ps(start);
  const __m256 factor = _mm256_set1_ps(0.999F);
  const __m256 term = _mm256_set1_ps(0.001F);
  for (std::size_t i = 0; i < kRounds; ++i) {
#pragma GCC unroll 12
    for (std::size_t k = 0; k < kChains; ++k) sums[k] = _mm256_fmadd_ps(sums[k], factor, term);
  }
  for (std::size_t k = 1; k < kChains; ++k) sums[0] = _mm256_add_ps(sums[0], sums[k]);
  return _mm256_cvtss_f32(sums[0]);
}

__attribute__((target("avx512f"))) float RunAvx512(float start) {
  __m512 sums[kChains];
  for (auto& sum : sums) sum = _mm512_set1_ps(start);
  const __m512 factor = _mm512_set1_ps(0.999F);
  const __m512 term = _mm512_set1_ps(0.001F);
  for (std::size_t i = 0; i < kRounds; ++i) {
#pragma GCC unroll 12
    for (std::size_t k = 0; k < kChains; ++k) sums[k] = _mm512_fmadd_ps(sums[k], factor, term);
  }
  for (std::size_t k = 1; k < kChains; ++k) sums[0] = _mm512_add_ps(sums[0], sums[k]);
  return _mm512_cvtss_f32(sums[0]);
}
#endif

double FmasPerSecond(float (*run)(float), std::size_t lanes) {
  using Clock = std::chrono::steady_clock;
  volatile float sink = 1.0F;
  sink = run(sink);  // brings the clock up
  const Clock::time_point start = Clock::now();
  sink = run(sink);
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  static_cast<void>(sink);
  return static_cast<double>(kRounds * kChains * lanes) / seconds;
}

}  // namespace

double MeasureFmaPeak(features::InstructionSet set) {
#if defined(__x86_64__)
  if (set == features::InstructionSet::kAvx2) return FmasPerSecond(&RunAvx2, 8);
  if (set == features::InstructionSet::kAvx512) return FmasPerSecond(&RunAvx512, 16);
#endif
  static_cast<void>(set);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace handcraft::experiments
