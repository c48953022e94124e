// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "lib/core/image.h"

namespace handcraft::datasets {

/// Reads a picture whose values are labels. A JPEG is refused, for it changes values: throws Error
/// as ReadImage does. 1 channel when the file is gray, else 3 (blue, green, red; palettes become
/// the colours they name).
[[nodiscard]] Image ReadLabelPicture(const std::filesystem::path& path);

/// As above, as one channel: a colour file is taken when its three channels are equal everywhere.
/// Throws Error with the first pixel where they are not.
[[nodiscard]] Image ReadLabelValues(const std::filesystem::path& path);

}  // namespace handcraft::datasets
