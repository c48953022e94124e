// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coco_runs.h"

#include <cstddef>
#include <cstdint>
#include <limits>

namespace handcraft::datasets {
namespace {

// Takes one number off the front of `text`.
std::optional<std::int64_t> TakeNumber(std::string_view& text) {
  constexpr int kGroupBits = 5;
  constexpr int kMaxBits = 40;  // a sign and 32 bits take 35
  std::int64_t value = 0;
  for (int num_bits = 0; num_bits < kMaxBits && !text.empty();) {
    const int code = text.front() - '0';
    if (code < 0 || code > 63) return std::nullopt;
    text.remove_prefix(1);
    value |= static_cast<std::int64_t>(code % 32) << num_bits;
    num_bits += kGroupBits;
    if (code < 32) {
      const bool is_negative = code >= 16;
      return is_negative ? value - (std::int64_t{1} << num_bits) : value;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<PixelRuns> DecodeCocoRuns(std::string_view text) {
  PixelRuns runs;
  while (!text.empty()) {
    const std::optional<std::int64_t> written = TakeNumber(text);
    if (!written) return std::nullopt;
    const std::int64_t run = *written + (runs.size() > 2 ? runs[runs.size() - 2] : 0);
    if (run < 0 || run > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
    runs.push_back(static_cast<std::uint32_t>(run));
  }
  return runs;
}

}  // namespace handcraft::datasets
