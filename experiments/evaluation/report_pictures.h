// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "experiments/evaluation/grasp_point_evaluation.h"
#include "lib/core/image.h"

namespace handcraft::experiments {

/// A BGR picture as the bytes of a JPEG file, shrunk to at most max_width_px. Throws
/// std::logic_error when the picture is empty or not BGR.
[[nodiscard]] std::vector<std::uint8_t> EncodeJpeg(const Image& image, int max_width_px);

/// The neighbourhood of the best pixel, enlarged: a sixth of the picture's width and height, with a
/// ring around each best pixel inside it, green on good, red on bad, blue on don't-care ground.
/// `picture` is gray or BGR. Empty when `best` is.
[[nodiscard]] Image DrawCloseUp(const Image& picture, std::span<const BestPixel> best);

}  // namespace handcraft::experiments
