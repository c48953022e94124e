// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "lib/core/file.h"

namespace handcraft::testing {

/// What Adobe's marker says the four channels are; without it nothing tells.
enum class InkCode { kUnmarked = -1, kCmyk = 0, kYcck = 2 };

/// Bits as a JPEG's scan holds them: from the high one on, 0 behind a byte of ones, ones at the
/// end.
class ScanBits {
 public:
  void Add(int value, int count) {
    for (int i = count - 1; i >= 0; --i) AddBit(value >> i & 1);
  }

  [[nodiscard]] std::vector<std::uint8_t> Bytes() {
    while (num_bits_ > 0) AddBit(1);
    return bytes_;
  }

 private:
  void AddBit(int bit) {
    byte_ = byte_ << 1 | bit;
    if (++num_bits_ < 8) return;
    bytes_.push_back(static_cast<std::uint8_t>(byte_));
    if (byte_ == 0xFF) bytes_.push_back(0);
    byte_ = num_bits_ = 0;
  }

  std::vector<std::uint8_t> bytes_;
  int byte_ = 0;
  int num_bits_ = 0;
};

/// Writes a baseline JPEG of four channels, each of one stored value everywhere: 128, or from 64 to
/// 127 away from it. A block's mean has the code 0 when it does not change and 10 with seven bits
/// when it does; 0 says that nothing else follows. Source: ITU-T T.81, annexes B and F; Adobe
/// Technical Note 5116.
inline void WriteInkJpeg(const std::filesystem::path& path,
                         int width,
                         int height,
                         InkCode code,
                         const std::array<int, 4>& stored) {
  std::vector<std::uint8_t> bytes = {0xFF, 0xD8};
  const auto append = [&bytes](const auto& values) {
    for (const int value : values) bytes.push_back(static_cast<std::uint8_t>(value));
  };
  if (code != InkCode::kUnmarked) {
    append(std::array{0xFF, 0xEE, 0, 14, 0x41, 0x64, 0x6F, 0x62, 0x65, 0, 100, 0, 0, 0, 0});
    append(std::array{static_cast<int>(code)});
  }
  append(std::array{0xFF, 0xDB, 0x00, 0x43, 0x00});
  bytes.insert(bytes.end(), 64, 8);  // so that a mean's step is one of the pixels
  append(std::array{0xFF, 0xC0, 0x00, 0x14, 8, height >> 8, height, width >> 8, width, 4});
  for (int channel = 1; channel <= 4; ++channel) append(std::array{channel, 0x11, 0x00});
  append(std::array{0xFF, 0xC4, 0x00, 0x15, 0x00, 1, 1});  // codes of one bit and of two
  bytes.insert(bytes.end(), 14, 0);
  append(std::array{0, 7});
  append(std::array{0xFF, 0xC4, 0x00, 0x14, 0x10, 1});
  bytes.insert(bytes.end(), 16, 0);
  append(std::array{0xFF, 0xDA, 0x00, 0x0E, 4, 1, 0, 2, 0, 3, 0, 4, 0, 0, 63, 0});
  ScanBits bits;
  for (const int value : stored) {
    const int change = value - 128;
    if (change == 0) bits.Add(0, 1);
    if (change != 0) bits.Add(0b10, 2);
    if (change != 0) bits.Add(change > 0 ? change : change + 127, 7);
    bits.Add(0, 1);
  }
  const int num_blocks = (width + 7) / 8 * ((height + 7) / 8);
  for (int i = 1; i < num_blocks; ++i) bits.Add(0, 8);
  append(bits.Bytes());
  append(std::array{0xFF, 0xD9});
  WriteFileAtomically(path, bytes);
}

}  // namespace handcraft::testing
