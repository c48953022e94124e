// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"
#include "datasets/importers/label_roles.h"

namespace handcraft::datasets {

struct CvatOptions {
  std::filesystem::path images = {};  ///< folder of the pictures; empty: JPEGImages in the source
  LabelRoles roles = {};
};

/// Lists an unpacked export "Segmentation mask 1.1" of CVAT: labelmap.txt (lines
/// label:red,green,blue:parts:actions), the names in ImageSets/Segmentation/*.txt and a coloured
/// mask SegmentationClass/NAME.png for each. Black means nothing unless labelmap.txt says
/// otherwise. Each picture is an instance of its own; the class is the first folder of its name,
/// else "object". Throws Error when a file is missing, has another form, or a mask holds a colour
/// that no label has. Source: CVAT's documentation of its formats.
[[nodiscard]] SourceSet ListCvat(const std::filesystem::path& source, const CvatOptions& options);

}  // namespace handcraft::datasets
