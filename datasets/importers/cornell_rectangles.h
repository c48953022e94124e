// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <vector>

#include "datasets/importers/grasp_mask.h"

namespace handcraft::datasets {

/// Reads `pcdNNNNcpos.txt`-like files: four lines "x y" a rectangle, in the order that
/// GraspRectangle wants. Rectangles with NaN corners (the original has some) and those without an
/// area (less than one pixel) are left out; anything else that is wrong throws Error with the line.
[[nodiscard]] std::vector<GraspRectangle> ReadCornellRectangles(const std::filesystem::path& path);

}  // namespace handcraft::datasets
