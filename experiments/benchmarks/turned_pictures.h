// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/image.h"

namespace handcraft::experiments {

inline constexpr int kNumTurns = 8;

/// The picture in one of its eight positions: bit 0 of `turn` mirrors left to right, bit 1 top to
/// bottom, bit 2 then swaps rows and columns. Turn 0 is the picture itself.
[[nodiscard]] Image Turn(const Image& image, int turn);

/// Writes the pictures of a set, in as many of the eight positions as it takes to have
/// `num_good` good pixels, to the folder `out` (which exists and is empty) and returns that set:
/// a small set that yields as many distinct samples as a large one. With all eight and still too
/// few, it is what there is.
[[nodiscard]] datasets::LabelledImageSet WriteTurnedPictures(const datasets::LabelledImageSet& set,
                                                             std::size_t num_good,
                                                             const std::filesystem::path& out);

}  // namespace handcraft::experiments
