// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

namespace handcraft::features {

/// Which pixels of a picture are wanted: those whose byte is not 0; row v at data + v · stride.
/// The picture's size is known from elsewhere.
struct PixelMask {
  const std::uint8_t* data = nullptr;
  std::ptrdiff_t stride = 0;

  [[nodiscard]] const std::uint8_t* Row(int v) const noexcept { return data + v * stride; }
};

/// A pixel by column and row.
struct PixelPosition {
  std::int32_t u = 0;
  std::int32_t v = 0;
};

/// How the wanted pixels of a picture are scored.
enum class ScoringWay : std::uint8_t {
  kDense,   ///< all pixels are, in strips; the unwanted are thrown away
  kSparse,  ///< row by row, runs of columns that hold wanted pixels
};

namespace internal {

/// Columns and rows from the first to before the last.
struct RegionBox {
  int first_u = 0;
  int last_u = 0;
  int first_v = 0;
  int last_v = 0;

  [[nodiscard]] bool empty() const noexcept { return first_u >= last_u || first_v >= last_v; }
};

}  // namespace internal

}  // namespace handcraft::features
