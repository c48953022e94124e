// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace handcraft {

/// The one random number generator: xoshiro256++ with distributions of our own, so that the same
/// seed gives the same draws with every compiler and standard library.
///
/// Seeded through SplitMix64. Not thread-safe: each task takes its own stream.
/// Source: Blackman and Vigna, "Scrambled linear pseudorandom number generators", 2021.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) noexcept;

  /// An independent stream for a named purpose: the draws depend on (seed, name, index) alone and
  /// not on what was drawn before, so work may be done in any order or thread.
  [[nodiscard]] static Rng Stream(std::uint64_t seed,
                                  std::string_view name,
                                  std::uint64_t index = 0) noexcept;

  /// 64 uniform bits.
  std::uint64_t Next() noexcept;

  /// Uniform in [0, 1), 53 bits.
  double Uniform() noexcept;

  /// Uniform in {0, …, bound − 1} without bias (Lemire 2019); bound ≥ 1.
  std::uint64_t UniformInt(std::uint64_t bound);

  /// Standard normal (Marsaglia's polar method; the second value of a pair is kept).
  double Normal() noexcept;

  /// Fisher–Yates shuffle.
  template <class T>
  void Shuffle(std::span<T> values) {
    for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[UniformInt(i)]);
  }

  /// `count` distinct indices out of {0, …, size − 1}, ascending (Vitter's selection sampling,
  /// Knuth 3.4.2 algorithm S): O(size) time, no memory beyond the result. Needs count ≤ size.
  [[nodiscard]] std::vector<std::size_t> SampleSorted(std::size_t size, std::size_t count);

 private:
  std::array<std::uint64_t, 4> state_;
  double spare_normal_ = 0.0;
  bool has_spare_normal_ = false;
};

}  // namespace handcraft
