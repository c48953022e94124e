// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/camera.h"
#include "lib/core/image.h"

namespace handcraft::synthetic {

/// The points that a depth picture of the camera's size stands for, in the base frame [m]:
/// p = origin + depth · ray(u, v). A depth that is 0, negative or not finite gives NaN.
[[nodiscard]] datasets::OrganisedCloud CloudFromDepth(const FloatImage& depth_m,
                                                      const PinholeCamera& camera);

}  // namespace handcraft::synthetic
