// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "lib/core/image.h"

namespace handcraft::datasets {

/// A rectangle as four corners [px]: the edge from corner 0 to corner 1 is the direction the
/// gripper opens.
using GraspRectangle = std::array<std::array<double, 2>, 4>;

/// What people or a simulation marked in one picture.
struct MarkedRectangles {
  std::vector<GraspRectangle> positive;
  std::vector<GraspRectangle> negative;  ///< where not to grasp
};

/// Its area [px²]; NaN when a corner is.
[[nodiscard]] double RectangleArea(const GraspRectangle& rectangle);

/// Why a picture whose rectangles were all passed over is left out.
inline constexpr const char* kNoUsableRectangle =
    "no usable rectangle in it: one with numbers for corners and a square pixel of area";

/// Throws Error naming `file` and the rectangle, counted from 1 in the order they are given, when
/// one lies wholly outside a picture of that size and so would mark nothing.
void RequireWithinPicture(const std::filesystem::path& file,
                          const std::vector<GraspRectangle>& rectangles,
                          int width,
                          int height);

/// How grasp rectangles become a label mask.
struct GraspMaskOptions {
  double good_share = 1.0 / 3.0;  ///< central share of the opening that is good, (0, 1]
  int dont_care_margin_px = 12;   ///< nothing nearer to a rectangle than this is called bad, ≥ 0

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// The mask of one picture. Each rule overrules those before it; a pixel counts by its centre:
///   1. bad, everywhere;
///   2. don't care, nearer than dont_care_margin_px to a positive rectangle;
///   3. bad, inside a negative rectangle;
///   4. don't care, inside a positive rectangle;
///   5. good, inside the central good_share of a positive rectangle, measured along its opening.
/// Corners that do not form a rectangle are replaced by the parallelogram of their mean edges.
/// Throws std::logic_error when a rectangle has no area.
[[nodiscard]] Image MakeGraspMask(int width,
                                  int height,
                                  const std::vector<GraspRectangle>& positive,
                                  const std::vector<GraspRectangle>& negative,
                                  const GraspMaskOptions& options);

}  // namespace handcraft::datasets
