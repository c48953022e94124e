// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/close_up.h"

#include <algorithm>

#include "lib/core/check.h"

namespace handcraft::datasets {
namespace {

using perception::PixelBox;

// Columns or rows.
struct Range {
  int begin = 0;
  int size = 0;
};

// As long as asked for, about the same middle, moved into [0, limit) or all of that.
Range Grown(const Range& range, int size, int limit) {
  const int length = std::min(size, limit);
  return {std::clamp(range.begin - (length - range.size) / 2, 0, limit - length), length};
}

}  // namespace

std::optional<PixelBox> FindBox(const Image& mask, std::uint8_t value) {
  HC_CHECK(mask.channels() == 1, mask.channels());
  int left = mask.width();
  int right = 0;
  int top = mask.height();
  int bottom = 0;
  for (int v = 0; v < mask.height(); ++v) {
    const std::uint8_t* const row = mask.Row(v);
    const std::uint8_t* const row_end = row + mask.width();
    const std::uint8_t* const first = std::find(row, row_end, value);
    if (first == row_end) continue;
    const std::uint8_t* last = row_end - 1;
    while (*last != value) --last;
    left = std::min(left, static_cast<int>(first - row));
    right = std::max(right, static_cast<int>(last - row) + 1);
    top = std::min(top, v);
    bottom = v + 1;
  }
  if (bottom == 0) return std::nullopt;
  return PixelBox{.u_px = left, .v_px = top, .width = right - left, .height = bottom - top};
}

PixelBox CloseUpOf(const PixelBox& box, int picture_width_px, int picture_height_px) {
  constexpr int kLeastMargin_px = 8;
  const int margin_px = std::max(std::max(box.width, box.height) / 4, kLeastMargin_px);
  const int width_px = box.width + 2 * margin_px;
  const int height_px = box.height + 2 * margin_px;
  const Range columns =
      Grown({box.u_px, box.width}, std::max(width_px, height_px * 4 / 3), picture_width_px);
  const Range rows =
      Grown({box.v_px, box.height}, std::max(height_px, width_px * 3 / 4), picture_height_px);
  return {.u_px = columns.begin, .v_px = rows.begin, .width = columns.size, .height = rows.size};
}

}  // namespace handcraft::datasets
