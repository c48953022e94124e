// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/image.h"

namespace handcraft::experiments {

/// Region R of a picture: 255 where grasp points are worth looking for, 0 elsewhere (search-space
/// reduction, lib/perception/search_region.h). The cloud is the picture's companion `cloud`, or its
/// `depth` with the intrinsics of dataset.toml and the camera's pose in its `scene`; up is the base
/// frame's z. Nowhere inside when nothing is found. Throws Error naming the picture when it has
/// neither, or they cannot be read. Thread-safe, deterministic.
/// Source: dissertation section 3.2.2.
[[nodiscard]] Image ObjectRegion(const datasets::LabelledImageSet& set,
                                 std::size_t item,
                                 const Image& picture);

}  // namespace handcraft::experiments
