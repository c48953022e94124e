// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "lib/core/image.h"

namespace handcraft::datasets {

struct CornellOptions;

/// A rectangle as four corners [px], in the order of the original files: the edge from corner 0 to
/// corner 1 is the direction the gripper opens.
using GraspRectangle = std::array<std::array<double, 2>, 4>;

/// Reads `pcdNNNNcpos.txt`-like files: four lines "x y" a rectangle. Rectangles with NaN corners
/// (the original has some) and those without an area (less than one pixel) are left out; anything
/// else that is wrong throws Error with the line.
[[nodiscard]] std::vector<GraspRectangle> ReadCornellRectangles(const std::filesystem::path& path);

/// The mask of one picture. Each rule overrules those before it; a pixel counts by its centre:
///   1. bad, everywhere;
///   2. don't care, nearer than dont_care_margin_px to a positive rectangle;
///   3. bad, inside a negative rectangle;
///   4. don't care, inside a positive rectangle;
///   5. good, inside the central good_share of a positive rectangle, measured along its opening.
/// Corners that do not form a rectangle are replaced by the parallelogram of their mean edges.
/// Throws std::logic_error when a rectangle has no area.
[[nodiscard]] Image MakeCornellMask(int width,
                                    int height,
                                    const std::vector<GraspRectangle>& positive,
                                    const std::vector<GraspRectangle>& negative,
                                    const CornellOptions& options);

}  // namespace handcraft::datasets
