// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/colour.h"

#include <algorithm>

namespace handcraft::features {
namespace {

constexpr int kShift = 14;  // fixed-point bits of the coefficients
constexpr int kHalf = 1 << (kShift - 1);

}  // namespace

Ycbcr ToYcbcr(std::uint8_t r, std::uint8_t g, std::uint8_t b) noexcept {
  const int y = (4899 * r + 9617 * g + 1868 * b + kHalf) >> kShift;
  const int offset = (128 << kShift) + kHalf;
  const int cr = ((r - y) * 11682 + offset) >> kShift;
  const int cb = ((b - y) * 9241 + offset) >> kShift;
  return {static_cast<std::uint8_t>(y),
          static_cast<std::uint8_t>(std::clamp(cb, 0, 255)),
          static_cast<std::uint8_t>(std::clamp(cr, 0, 255))};
}

}  // namespace handcraft::features
