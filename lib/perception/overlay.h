// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include "lib/core/image.h"

namespace handcraft::perception {

/// A marked pixel: where, and how good in 0..1.
struct MarkedPoint {
  int u_px = 0;
  int v_px = 0;
  float probability = 0.0F;
};

/// The picture (gray or BGR) in colour with the probability map blended over it (transparent at 0,
/// warm at 1; an empty map draws nothing), and the points as numbered circles, best first.
/// Throws std::logic_error when the map has another size than the picture.
[[nodiscard]] Image DrawGraspPoints(const Image& image,
                                    const FloatImage& probabilities,
                                    std::span<const MarkedPoint> points);

/// The picture with a label mask over it: good (255) green, don't care (128) blue, bad (0)
/// untouched. Around what is good runs a line, white and beyond it black, each a 256th of the
/// longer side wide; pictures shorter than 128 pixels have none.
[[nodiscard]] Image DrawLabelMask(const Image& image, const Image& mask);

/// The picture with the pixels of a region (not 0 in the mask) tinted blue.
[[nodiscard]] Image DrawRegion(const Image& image, const Image& mask);

}  // namespace handcraft::perception
