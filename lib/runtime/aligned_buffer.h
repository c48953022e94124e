// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <span>

namespace handcraft::runtime {

/// Memory aligned to 64 bytes, as the pixel scorer wants it. Left uninitialised.
class AlignedBuffer {
 public:
  /// Throws std::bad_alloc.
  explicit AlignedBuffer(std::size_t num_bytes)
      : bytes_(static_cast<std::byte*>(::operator new(num_bytes, kAlignment))), size_(num_bytes) {}

  [[nodiscard]] std::span<std::byte> Bytes() const noexcept { return {bytes_.get(), size_}; }

 private:
  static constexpr std::align_val_t kAlignment{64};
  struct Deleter {
    void operator()(std::byte* bytes) const noexcept { ::operator delete(bytes, kAlignment); }
  };

  std::unique_ptr<std::byte, Deleter> bytes_;
  std::size_t size_;
};

}  // namespace handcraft::runtime
