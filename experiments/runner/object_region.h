// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/image.h"
#include "lib/perception/search_region.h"

namespace handcraft::experiments {

/// Search-space reduction of a picture, by lib/perception/search_region.h with its defaults. The
/// cloud is the picture's companion `cloud`, or its `depth` with the intrinsics of dataset.toml and
/// the camera's pose in its `scene`; up is the base frame's z. It must have one (RequireDepth).
/// Throws Error naming the file when one cannot be read or is of another size. Thread-safe;
/// deterministic but for the times. Source: dissertation section 3.2.2.
[[nodiscard]] perception::SearchRegion FindObjectRegion(const datasets::LabelledImageSet& set,
                                                        std::size_t item,
                                                        const Image& picture);

/// Throws Error, saying how many pictures it is and naming the first, unless each picture of the
/// set has what FindObjectRegion needs. Opens no file.
void RequireDepth(const datasets::LabelledImageSet& set);

/// SHA-256, in hexadecimal, over all that FindObjectRegion reads beside the pictures. Throws Error
/// naming the file that cannot be read.
[[nodiscard]] std::string DepthFingerprint(const datasets::LabelledImageSet& set);

}  // namespace handcraft::experiments
