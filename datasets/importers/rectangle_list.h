// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/importers/grasp_mask.h"

namespace handcraft::datasets {

/// The rectangles of a picture of a set, by its path in the manifest.
struct RectanglesOfImage {
  std::string image;
  MarkedRectangles rectangles;
};

/// Writes root/rectangles.csv, atomically: a line a rectangle with the columns image, good (1 or 0)
/// and the corners u1_px, v1_px … v4_px in the order of GraspRectangle. Measures that compare a
/// found grasp with marked ones need them; masks do not hold them. Throws Error when it cannot.
void WriteRectangles(const std::filesystem::path& root, const std::vector<RectanglesOfImage>& list);

}  // namespace handcraft::datasets
