// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace handcraft::testing {

using ByteVector = std::vector<std::uint8_t>;

/// Writes PNG files byte by byte, of kinds an encoder would not make: palettes, alpha, 16 bits,
/// false sizes. Source: PNG 3rd edition; pixel data goes into stored deflate blocks (RFC 1950).
class PngBuilder {
 public:
  PngBuilder(std::uint32_t width, std::uint32_t height, int bit_depth, int colour_type) {
    bytes_ = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    ByteVector header;
    Append(header, width);
    Append(header, height);
    for (const int value : {bit_depth, colour_type, 0, 0, 0}) {
      header.push_back(static_cast<std::uint8_t>(value));
    }
    Chunk("IHDR", header);
  }

  PngBuilder& Chunk(std::string_view type, const ByteVector& data) {
    Append(bytes_, static_cast<std::uint32_t>(data.size()));
    ByteVector body(type.begin(), type.end());
    body.insert(body.end(), data.begin(), data.end());
    bytes_.insert(bytes_.end(), body.begin(), body.end());
    Append(bytes_, Crc(body));
    return *this;
  }

  /// Rows as PNG wants them: a filter byte (0) and the packed samples of each. At most 65535 bytes.
  PngBuilder& Pixels(const ByteVector& rows) {
    ByteVector data = {0x78, 0x01, 0x01};
    const auto size = static_cast<std::uint16_t>(rows.size());
    for (const int value : {size & 0xFF, size >> 8, ~size & 0xFF, (~size >> 8) & 0xFF}) {
      data.push_back(static_cast<std::uint8_t>(value));
    }
    data.insert(data.end(), rows.begin(), rows.end());
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::uint8_t value : rows) {
      a = (a + value) % 65521;
      b = (b + a) % 65521;
    }
    Append(data, b << 16 | a);
    return Chunk("IDAT", data);
  }

  ByteVector End() { return Chunk("IEND", {}).bytes_; }

 private:
  static void Append(ByteVector& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
  }

  static std::uint32_t Crc(const ByteVector& bytes) {
    std::uint32_t crc = ~0U;
    for (const std::uint8_t byte : bytes) {
      crc ^= byte;
      for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xEDB88320U & (0U - (crc & 1U)));
    }
    return ~crc;
  }

  ByteVector bytes_;
};

}  // namespace handcraft::testing
