// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lib/core/image.h"

namespace handcraft::experiments {

/// A labelled pixel, as index row · width + column, and its label.
struct EvaluationPixel {
  std::size_t index = 0;
  std::uint8_t label = 0;  ///< 1 good, 0 bad
};

/// The labelled pixels of one picture on which the classifier is judged: count / 2 good and as many
/// bad, or as many of each as the scarcer kind has, so that guessing is right half the time. A mask
/// with one kind alone gives count / 2 of that kind; don't-care pixels are never drawn. Good ones
/// first, each kind in row-major order, none twice.
///
/// The draw depends on (seed, image_name, mask) alone: not on the other pictures, their order, or
/// threads. O(width · height).
[[nodiscard]] std::vector<EvaluationPixel> DrawEvaluationPixels(const Image& mask,
                                                                std::size_t count,
                                                                std::uint64_t seed,
                                                                std::string_view image_name);

}  // namespace handcraft::experiments
