// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

struct ContactSheetOptions {
  int images_per_class = 2;  ///< at most this many of each class, evenly spread over it; 1 ... 100
  int tile_width_px = 128;   ///< a tile is three quarters as high; 16 ... 640
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// One picture of a whole set: a row a class, in alphabetical order, and in it each picture twice,
/// as it is and with its labels over it (good green, don't care blue). Pictures are scaled to fit
/// their tile, on black. Colours are rounded to 32 levels, so that the file stays small. Throws
/// Error for pictures and masks that cannot be read, and for a set without pictures.
[[nodiscard]] Image MakeContactSheet(const LabelledImageSet& set,
                                     const ContactSheetOptions& options);

}  // namespace handcraft::datasets
