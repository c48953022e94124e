// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"
#include "datasets/importers/label_roles.h"

namespace handcraft::datasets {

/// Lists the pictures of a folder of LabelMe files: NAME.json, in it shapes (polygon, rectangle,
/// circle) with a label each, and the picture, embedded (imageData) or beside the file (imagePath).
/// An embedded one goes before one beside, as LabelMe has it. Files further down are read too. Each
/// picture is an instance of its own; the class is its first folder, else "object". Throws Error
/// with the place in the file when it is not as LabelMe writes it, a shape that has a role is of
/// another type, or a picture's name leads out of the folder.
[[nodiscard]] SourceSet ListLabelme(const std::filesystem::path& source, const LabelRoles& roles);

}  // namespace handcraft::datasets
