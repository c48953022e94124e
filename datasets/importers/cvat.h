// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"
#include "datasets/importers/label_roles.h"

namespace handcraft::datasets {

struct CvatOptions {
  /// Folder of the pictures; empty: JPEGImages or images in the source, as the export has it.
  std::filesystem::path images = {};
  LabelRoles roles = {};
};

/// Lists an unpacked export of CVAT, of one of two kinds, told apart by what `source` holds:
/// annotations.xml (or `source` is an XML file), "CVAT for images 1.1", for which see
/// cvat_shapes.h; labelmap.txt, "Segmentation mask 1.1": lines label:red,green,blue:parts:actions
/// in it, the names in ImageSets/Segmentation/*.txt and a coloured mask SegmentationClass/NAME.png
/// for each. Black means nothing unless labelmap.txt says otherwise. Each picture is an instance of
/// its own; the class is the first folder of its name, else "object". A picture that is missing, or
/// whose mask is, is left out and stands in the notes. Throws Error when a list is missing, a file
/// has another form, or a mask holds a colour that no label has. Source: CVAT's
/// documentation, "Formats".
[[nodiscard]] SourceSet ListCvat(const std::filesystem::path& source, const CvatOptions& options);

}  // namespace handcraft::datasets
