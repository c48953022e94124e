// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/cost_order.h"

#include <array>
#include <bit>
#include <utility>

namespace handcraft::robot {
namespace {

constexpr std::size_t kNumDigits = 3;
constexpr std::size_t kNumValues = 256;

// Bits of a float ≥ 0 order as the numbers do. Key in the upper half, place in the lower.
std::uint64_t KeyAndPlace(double cost, std::size_t place) noexcept {
  const auto key = std::bit_cast<std::uint32_t>(static_cast<float>(cost)) >> 8U;
  return (static_cast<std::uint64_t>(key) << 32U) | place;
}

}  // namespace

void OrderByCost(std::span<const double> costs,
                 std::vector<std::uint32_t>& order,
                 std::vector<std::uint64_t>& scratch) {
  const std::size_t n = costs.size();
  order.resize(n);
  if (scratch.size() < 2 * n) scratch.resize(2 * n);
  std::uint64_t* from = scratch.data();
  std::uint64_t* to = from + n;
  std::array<std::array<std::uint32_t, kNumValues>, kNumDigits> counts{};
  for (std::size_t i = 0; i < n; ++i) {
    from[i] = KeyAndPlace(costs[i], i);
    for (std::size_t d = 0; d < kNumDigits; ++d)
      ++counts[d][(from[i] >> (32 + 8 * d)) % kNumValues];
  }
  for (std::size_t d = 0; d < kNumDigits; ++d) {
    std::uint32_t start = 0;
    for (std::uint32_t& count : counts[d]) {
      const std::uint32_t next = start + count;
      count = start;
      start = next;
    }
    for (std::size_t i = 0; i < n; ++i)
      to[counts[d][(from[i] >> (32 + 8 * d)) % kNumValues]++] = from[i];
    std::swap(from, to);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const auto place = static_cast<std::uint32_t>(from[i]);
    std::size_t at = i;
    for (; at > 0 && costs[place] < costs[order[at - 1]]; --at) order[at] = order[at - 1];
    order[at] = place;
  }
}

}  // namespace handcraft::robot
