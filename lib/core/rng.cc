// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/rng.h"

#include <bit>
#include <cmath>

#include "lib/core/check.h"

namespace handcraft {
namespace {

std::uint64_t SplitMix64(std::uint64_t& state) noexcept {
  state += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// FNV-1a, 64 bits: a stable hash of the stream's name.
std::uint64_t HashName(std::string_view name) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

Rng::Rng(std::uint64_t seed) noexcept : state_{} {
  for (std::uint64_t& word : state_) word = SplitMix64(seed);
}

Rng Rng::Stream(std::uint64_t seed, std::string_view name, std::uint64_t index) noexcept {
  std::uint64_t state = seed;
  std::uint64_t mixed = SplitMix64(state);
  state = mixed ^ HashName(name);
  mixed = SplitMix64(state);
  state = mixed ^ index;
  return Rng(SplitMix64(state));
}

std::uint64_t Rng::Next() noexcept {
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Rng::Uniform() noexcept { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }

std::uint64_t Rng::UniformInt(std::uint64_t bound) {
  HC_CHECK(bound >= 1, bound);
  // Reject the draws that would make the low residues more likely than the others.
  const std::uint64_t threshold = (0 - bound) % bound;
  while (true) {
    const unsigned __int128 product = static_cast<unsigned __int128>(Next()) * bound;
    if (static_cast<std::uint64_t>(product) >= threshold) {
      return static_cast<std::uint64_t>(product >> 64);
    }
  }
}

double Rng::Normal() noexcept {
  if (has_spare_normal_) {
    has_spare_normal_ = false;
    return spare_normal_;
  }
  double u = 0.0;
  double v = 0.0;
  double radius_squared = 0.0;
  do {
    u = 2.0 * Uniform() - 1.0;
    v = 2.0 * Uniform() - 1.0;
    radius_squared = u * u + v * v;
  } while (radius_squared >= 1.0 || radius_squared == 0.0);
  const double factor = std::sqrt(-2.0 * std::log(radius_squared) / radius_squared);
  spare_normal_ = v * factor;
  has_spare_normal_ = true;
  return u * factor;
}

std::vector<std::size_t> Rng::SampleSorted(std::size_t size, std::size_t count) {
  HC_CHECK(count <= size, count, size);
  std::vector<std::size_t> chosen;
  chosen.reserve(count);
  for (std::size_t i = 0; chosen.size() < count; ++i) {
    if (UniformInt(size - i) < count - chosen.size()) chosen.push_back(i);
  }
  return chosen;
}

}  // namespace handcraft
