// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/view_set.h"
#include "datasets/synthetic/camera.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

struct DemonstrationSheetOptions {
  int views_per_class = 3;  ///< at most this many of each class, evenly spread over it; 1 ... 100
  int poses_per_view = 24;  ///< at most this many in a view, evenly spread over its rows; 1 ... 10⁴
  int tile_width_px = 240;  ///< a tile is three quarters as high; 16 ... 640
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Draws a hand at each pose into a picture in colour, as the camera sees it: a stem along the
/// approach axis (yellow), a bar along the closing axis, and two prongs from it to the grasp
/// centre, 20 mm to either side: the fingers' (+x) orange, the thumb's blue. A pose that is not
/// wholly in front of the camera is left out.
void DrawHands(Image& picture,
               const synthetic::PinholeCamera& camera,
               std::span<const EndEffectorPose> poses);

/// One picture of a demonstration set: a row a class, in alphabetical order, and in it some of its
/// views about the object, with hands at their poses. Where the camera stood is found from each
/// view's cloud (FitCamera). Colours are rounded to 32 levels. Throws Error for files that cannot
/// be read and for a view to be drawn that has no cloud or no object in its mask.
[[nodiscard]] Image MakeDemonstrationSheet(const DemonstrationSet& demonstrations,
                                           const ViewSet& views,
                                           const DemonstrationSheetOptions& options);

}  // namespace handcraft::datasets
