// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/organised_cloud.h"
#include "datasets/importers/image_set_import.h"
#include "lib/core/image.h"

/// What stands in for the cloud of a view that has none.
namespace handcraft::datasets {

inline constexpr double kFlatDepth_m = 1.0;
inline constexpr double kFlatFocal_px = 1000.0;  ///< one pixel is one millimetre there

/// The silhouette as a flat cloud: every pixel of the mask that is not 0 lies kFlatDepth_m before a
/// camera of kFlatFocal_px that looks along the base's x, z upwards, through the middle of the
/// picture; the others are NaN. Nothing of it was measured but the outline.
[[nodiscard]] OrganisedCloud FlatCloudOf(const Image& mask);

/// Gives every picture without a cloud the flat one of its mask.
void AddFlatClouds(SourceSet& source);

}  // namespace handcraft::datasets
