// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <vector>

#include "lib/core/image.h"

namespace handcraft::datasets {

/// The gray pictures of an NPY file: an array of rank 3 (picture, row, column) of bytes (uint8), C
/// order, NPY format 1, 2 or 3. Throws Error with the byte for another kind of array, a length that
/// does not fit the shape, an array without pixels and pictures of more than 65535 pixels a side.
[[nodiscard]] std::vector<Image> ReadNpyPictures(const std::filesystem::path& path);

}  // namespace handcraft::datasets
