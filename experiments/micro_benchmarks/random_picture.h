// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "lib/core/image.h"
#include "lib/core/rng.h"

namespace handcraft::experiments {

/// 640 × 480 bytes of noise: the time of a filter does not depend on what a picture shows.
inline Image RandomPicture(int channels) {
  Rng rng = Rng::Stream(1, "micro_benchmarks.picture");
  Image image(640, 480, channels);
  for (int v = 0; v < image.height(); ++v) {
    for (int x = 0; x < image.width() * channels; ++x) {
      image.Row(v)[x] = static_cast<std::uint8_t>(rng.UniformInt(256));
    }
  }
  return image;
}

}  // namespace handcraft::experiments
