// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// The pictures of a set with their masks, both `scale` times as large, as a set of its own below
/// `folder`: item i is item i of `set`, with its class, instance, split and licence. Pictures are
/// averaged over areas when they shrink and interpolated linearly when they grow; masks take the
/// nearest pixel, so that they keep their three values. A side is never less than one pixel.
///
/// The folder appears whole or not at all; when it is there it is read, not made again. The number
/// of threads changes no byte. Throws Error when a picture cannot be read or the folder not be
/// written; std::logic_error unless scale is in [0.1, 10].
/// Source: dissertation section 3.1.3 ("scale the images and treat them as new images for
/// training").
[[nodiscard]] LabelledImageSet ProvideScaledSet(const LabelledImageSet& set,
                                                double scale,
                                                const std::filesystem::path& folder,
                                                int num_threads,
                                                const Progress& progress);

}  // namespace handcraft::datasets
