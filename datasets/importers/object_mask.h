// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>

#include "lib/core/image.h"

/// Masks of views: kObject where the object is seen, else kNoObject.
namespace handcraft::datasets {

/// The mask that a silhouette file holds: nonzero is the object. Throws Error when it holds
/// colours, is a JPEG or not of this size [px].
[[nodiscard]] Image ReadObjectMask(const std::filesystem::path& path, int width, int height);

/// The mask of an object before a dark background, gray or colour: all but the pixels whose
/// channels are at most `threshold` and that are joined, by sides, to the picture's edge through
/// such pixels. Dark places within the object belong to it.
[[nodiscard]] Image MaskBeforeDarkness(const Image& image, std::uint8_t threshold);

}  // namespace handcraft::datasets
