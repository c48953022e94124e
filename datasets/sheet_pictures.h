// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "datasets/contact_sheet.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/organised_cloud.h"
#include "datasets/formats/view_set.h"

/// What contact sheets show of each kind of set. The set must outlive the pictures.
namespace handcraft::datasets {

/// How much of a picture its labels are shown on.
enum class Framing {
  kWhole,
  kCloseUp,  ///< the object's box with a margin (CloseUpOf), so that small objects can be judged
};

/// Each picture as it is and with its labels over it: good green, don't care blue. With close-ups:
/// the whole picture, its close-up, and that with its labels; the object is what the object mask
/// shows or, where there is none, what is good; without such a pixel it is all of the picture.
[[nodiscard]] std::vector<SheetPicture> SheetPicturesOf(const LabelledImageSet& set,
                                                        Framing framing = Framing::kWhole);

/// Each picture as it is, its cloud's depths as DrawDepths shows them (black where it has none),
/// and the picture with its object in green; with close-ups the last two are of the object's.
[[nodiscard]] std::vector<SheetPicture> SheetPicturesOf(const ViewSet& set,
                                                        Framing framing = Framing::kWhole);

/// A cloud's depths along the optical axis as colours: from red, the nearest of the object, to
/// blue, the farthest; what lies before or behind has the colour of that end, what was not measured
/// is black. `object_mask` is of the cloud's size; without an object the whole cloud counts.
[[nodiscard]] Image DrawDepths(const OrganisedCloud& cloud, const Image& object_mask);

}  // namespace handcraft::datasets
