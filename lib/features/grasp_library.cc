// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/grasp_library.h"

#include <span>

namespace handcraft::features {
namespace {

// Rows first … last − 1 of numbers that come `width` a row.
template <class T>
std::span<const T> Rows(const std::vector<T>& values,
                        std::size_t first,
                        std::size_t last,
                        std::size_t width) noexcept {
  return std::span(values).subspan(first * width, (last - first) * width);
}

}  // namespace

ShownClass GraspLibrary::Class(std::size_t number) const noexcept {
  const auto first_view = static_cast<std::size_t>(view_begins[number]);
  const auto last_view = static_cast<std::size_t>(view_begins[number + 1]);
  const auto first_angle = static_cast<std::size_t>(angle_begins[number]);
  const auto last_angle = static_cast<std::size_t>(angle_begins[number + 1]);
  return {.views = {.normals = Rows(view_normals, first_view, last_view, 3),
                    .moments = Rows(view_moments, first_view, last_view, kNumMoments),
                    .scales = Rows(moment_scales, number, number + 1, kNumMoments)},
          .view_angles_rad = Rows(view_angles_rad, first_view, last_view, 1),
          .shown_angles_rad = Rows(shown_angles_rad, first_angle, last_angle, 1),
          .begins = Rows(pose_begins, first_angle, last_angle + 1, 1),
          .positions_m = positions_m,
          .rotations = rotations,
          .numbers = numbers};
}

}  // namespace handcraft::features
