// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "lib/runtime/crc32c.h"

namespace handcraft::testing {

/// Replaces the last eight bytes by the checksum of all before them.
inline void Seal(std::vector<std::uint8_t>& bytes) {
  const std::uint32_t checksum = runtime::Crc32c({bytes.data(), bytes.size() - 8});
  std::memcpy(bytes.data() + bytes.size() - 8, "C32C", 4);
  std::memcpy(bytes.data() + bytes.size() - 4, &checksum, 4);
}

/// A model file from its header's text and the tensors' bytes without the checksum's, written by
/// hand rather than by the library's writer. The header is padded; the checksum is right.
inline std::vector<std::uint8_t> RawModel(std::string header,
                                          const std::vector<std::uint8_t>& data) {
  while ((header.size() + 8) % 64 != 0) header += ' ';
  const std::uint64_t length = header.size();
  std::vector<std::uint8_t> bytes(8 + header.size() + data.size() + 8);
  std::memcpy(bytes.data(), &length, 8);
  std::copy(header.begin(), header.end(), bytes.begin() + 8);
  std::copy(data.begin(), data.end(), bytes.end() - 8 - static_cast<std::ptrdiff_t>(data.size()));
  Seal(bytes);
  return bytes;
}

/// `text` with the first `from` replaced by `to`; `from` must be there.
inline std::string Replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A small valid header: a = F32[2], b = U8[3], and the checksum.
inline constexpr std::string_view kSmallHeader =
    R"({"__metadata__":{"hc.format":"1.0","hc.kind":"none"},)"
    R"("a":{"dtype":"F32","shape":[2],"data_offsets":[0,8]},)"
    R"("b":{"dtype":"U8","shape":[1,3],"data_offsets":[8,11]},)"
    R"("zz.crc":{"dtype":"U8","shape":[8],"data_offsets":[11,19]}})";

/// Its data: a = {1, 2}, b = {7, 8, 9}.
inline std::vector<std::uint8_t> SmallData() { return {0, 0, 0x80, 0x3F, 0, 0, 0, 0x40, 7, 8, 9}; }

}  // namespace handcraft::testing
