// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace handcraft {

/// SHA-256 of a stream of bytes: the identity of model files and the fingerprint of data sets.
/// Source: FIPS 180-4, section 6.2. Not thread-safe; one object a stream.
class Sha256 {
 public:
  Sha256() noexcept;

  void Update(std::span<const std::uint8_t> bytes) noexcept;
  void Update(std::string_view text) noexcept;

  /// 64 lower-case hexadecimal digits of everything fed so far; the object is spent afterwards.
  [[nodiscard]] std::string HexDigest();

 private:
  void Compress(const std::uint8_t* block) noexcept;

  std::array<std::uint32_t, 8> state_;
  std::array<std::uint8_t, 64> buffer_{};
  std::size_t buffered_ = 0;
  std::uint64_t total_bytes_ = 0;
};

/// Digest of one piece of memory.
[[nodiscard]] std::string Sha256Hex(std::span<const std::uint8_t> bytes);

}  // namespace handcraft
