// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "datasets/contact_sheet.h"
#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/view_set.h"
#include "datasets/synthetic/camera.h"
#include "lib/core/image.h"
#include "lib/perception/search_region.h"

namespace handcraft::datasets {

struct DemonstrationSheetOptions {
  int poses_per_view =
      24;  ///< at most this many poses or holds in a view, evenly spread over its rows; 1 ... 10⁴
  int tile_width_px = 240;  ///< of the sheet that they are drawn for; 16 ... 640

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Which hand, by the colour of its stem.
enum class Hand {
  kRight,  ///< yellow
  kLeft,   ///< violet
};

/// Draws a hand at each pose into a picture in colour, as the camera sees it: a stem along the
/// approach axis and a bar along the closing axis in the colour of the hand, and two prongs from it
/// to the grasp centre, 20 mm to either side: the fingers' (+x) orange, the thumb's blue. A pose
/// that is not wholly in front of the camera is left out. Lines that are wider than a pixel have a
/// black rim, so that they show on any ground.
void DrawHands(Image& picture,
               const synthetic::PinholeCamera& camera,
               std::span<const EndEffectorPose> poses,
               Hand hand = Hand::kRight,
               int line_width_px = 1);

/// A part of a picture, scaled, and the camera that sees it so.
struct PicturePart {
  Image picture;  ///< in colour
  synthetic::PinholeCamera camera;
};

/// The part with the box in its middle, about twice as large as that, four to three, moved into the
/// picture and scaled to this width.
[[nodiscard]] PicturePart PartAbout(const Image& picture,
                                    const perception::PixelBox& box,
                                    const synthetic::PinholeCamera& camera,
                                    int width_px);

/// What contact sheets show of a demonstration set: of each view with poses the part about its
/// object, with hands at them. Where the camera stood is found from the view's cloud (FitCamera).
/// Drawing throws Error for files that cannot be read and for a view that has no cloud or no object
/// in its mask. The views must outlive the pictures.
[[nodiscard]] std::vector<SheetPicture> SheetPicturesOf(const DemonstrationSet& demonstrations,
                                                        const ViewSet& views,
                                                        const DemonstrationSheetOptions& options);

/// The same of a set of holds: both hands of each.
[[nodiscard]] std::vector<SheetPicture> SheetPicturesOf(const HoldSet& holds,
                                                        const ViewSet& views,
                                                        const DemonstrationSheetOptions& options);

}  // namespace handcraft::datasets
