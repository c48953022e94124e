// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"
#include "datasets/importers/label_roles.h"

namespace handcraft::datasets {

struct CocoOptions {
  std::filesystem::path images = {};  ///< folder of the pictures; empty: that of the JSON file
  LabelRoles roles = {};              ///< of categories, by name
};

/// Lists the pictures of a COCO file of object segmentations: outlines as polygons, as runs, or as
/// compressed runs. Where an annotation with a role is a crowd (iscrowd 1), its pixels are don't
/// care. Pictures without annotations are bad everywhere. Each picture is an instance of its own;
/// the class is the first folder of its name, else "object". Throws Error with the place in the
/// file when it is not as COCO specifies, runs do not fit the picture, an annotation with a role
/// has no outline, or a picture's name leads out of the folder. Source:
/// https://cocodataset.org/#format-data and the COCO API's maskApi.
[[nodiscard]] SourceSet ListCoco(const std::filesystem::path& file, const CocoOptions& options);

}  // namespace handcraft::datasets
