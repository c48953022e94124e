// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "lib/core/check.h"
#include "lib/core/image.h"
#include "lib/perception/search_region.h"

/// The part of a picture in which something stands.
namespace handcraft::datasets {

/// The box of the pixels of one value, of a mask with one channel; nothing when it has none.
[[nodiscard]] std::optional<perception::PixelBox> FindBox(const Image& mask, std::uint8_t value);

/// The box with a margin around it of a quarter of its longer side, at least 8 px, and then
/// widened or heightened to four by three; moved into the picture, and cut where it is larger.
[[nodiscard]] perception::PixelBox CloseUpOf(const perception::PixelBox& box,
                                             int picture_width_px,
                                             int picture_height_px);

/// The pixels of a box, which lies in the picture.
template <class T>
[[nodiscard]] BasicImage<T> CutOut(const BasicImage<T>& picture, const perception::PixelBox& box) {
  HC_CHECK(box.u_px >= 0 && box.u_px + box.width <= picture.width(), box.u_px, box.width);
  HC_CHECK(box.v_px >= 0 && box.v_px + box.height <= picture.height(), box.v_px, box.height);
  BasicImage<T> part(box.width, box.height, picture.channels());
  for (int v = 0; v < box.height; ++v) {
    const T* const row = &picture.At(box.u_px, box.v_px + v);
    std::copy_n(row, box.width * picture.channels(), part.Row(v));
  }
  return part;
}

}  // namespace handcraft::datasets
