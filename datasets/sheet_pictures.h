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

/// Each picture as it is and with its labels over it: good green, don't care blue.
[[nodiscard]] std::vector<SheetPicture> SheetPicturesOf(const LabelledImageSet& set);

/// Each picture as it is, its cloud's depths as DrawDepths shows them (black where it has none),
/// and the picture with its object in green.
[[nodiscard]] std::vector<SheetPicture> SheetPicturesOf(const ViewSet& set);

/// A cloud's depths along the optical axis as colours: from red, the nearest of the object, to
/// blue, the farthest; what lies before or behind has the colour of that end, what was not measured
/// is black. `object_mask` is of the cloud's size; without an object the whole cloud counts.
[[nodiscard]] Image DrawDepths(const OrganisedCloud& cloud, const Image& object_mask);

}  // namespace handcraft::datasets
