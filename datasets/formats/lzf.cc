// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/lzf.h"

namespace handcraft::datasets {
namespace {

constexpr std::size_t kFirstReference = 32;
constexpr std::size_t kLongLength = 7;

}  // namespace

std::optional<std::vector<std::uint8_t>> UnpackLzf(std::span<const std::uint8_t> packed,
                                                   std::size_t size) {
  if (size / kMostLzfGrowth > packed.size()) return std::nullopt;  // before memory is taken
  std::vector<std::uint8_t> bytes;
  bytes.reserve(size);
  for (std::size_t at = 0; at < packed.size();) {
    const std::size_t control = packed[at++];
    if (control < kFirstReference) {
      const std::size_t count = control + 1;
      if (count > packed.size() - at || count > size - bytes.size()) return std::nullopt;
      bytes.insert(bytes.end(), &packed[at], &packed[at] + count);
      at += count;
      continue;
    }
    std::size_t length = control >> 5U;
    const std::size_t num_more = length == kLongLength ? 2 : 1;
    if (num_more > packed.size() - at) return std::nullopt;
    if (length == kLongLength) length += packed[at++];
    length += 2;
    const std::size_t distance = ((control & 31U) << 8U | packed[at++]) + 1;
    if (distance > bytes.size() || length > size - bytes.size()) return std::nullopt;
    // One by one: what is copied may be what this very copy wrote.
    for (std::size_t i = 0; i < length; ++i) bytes.push_back(bytes[bytes.size() - distance]);
  }
  if (bytes.size() != size) return std::nullopt;
  return bytes;
}

}  // namespace handcraft::datasets
