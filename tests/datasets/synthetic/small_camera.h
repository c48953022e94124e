// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/synthetic/camera.h"

namespace handcraft::synthetic::testing {

/// The usual camera at a quarter of its resolution: pictures of 160 × 120.
inline PinholeCamera SmallCamera() {
  return {.width_px = 160,
          .height_px = 120,
          .focal_px = 131.25F,
          .centre_u_px = 79.5F,
          .centre_v_px = 59.5F};
}

}  // namespace handcraft::synthetic::testing
