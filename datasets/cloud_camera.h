// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/camera.h"

namespace handcraft::datasets {

/// The pinhole camera that a cloud was measured by, for drawing into its picture: the focal length
/// and the centre with the least sum of squared pixel errors of
///     u = focal · x / z + centre_u,   v = focal · y / z + centre_v
/// over the measured points (x, y, z in the camera's frame). Throws Error(kBadInput) without a path
/// when fewer than 10 points are measured in front of the camera, when they lie in one direction,
/// or when the root mean squared error is above 2 pixels (no pinhole camera, or rows and columns
/// mixed up).
[[nodiscard]] synthetic::PinholeCamera FitCamera(const OrganisedCloud& cloud);

}  // namespace handcraft::datasets
