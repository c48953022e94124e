// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string_view>

#include "datasets/formats/mask_picture.h"

namespace handcraft::datasets {

/// Opens the file that a list names beside a picture, in the column object_mask, depth, cloud,
/// scene or right_image, and reads all of it. Throws Error when it cannot be read, is not of its
/// kind (a scene is one: ReadSceneFile), or is not of the picture's size.
void CheckCompanion(std::string_view column,
                    const std::filesystem::path& path,
                    const PixelSize& picture_size);

}  // namespace handcraft::datasets
