// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/cvat.h"
#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

/// Lists the pictures of a file "CVAT for images 1.1": XML with an <image> for each picture, in it
/// <polygon>, <box> and <mask> elements with a label each. A mask is runs along the rows of a box,
/// outside first. Pictures lie below `options.images`, without it in images/ beside the file; in a
/// folder named after their subset where they have one. Pictures without shapes are bad everywhere.
/// Each is an instance of its own; the class is the first folder of its name, else "object". Throws
/// Error with the line when the file is not as CVAT writes it, a shape that has a role is of
/// another type or leaves the picture, or a picture's name leads out of the folder. Source: CVAT's
/// documentation, "XML annotation format", version 1.1.
[[nodiscard]] SourceSet ListCvatShapes(const std::filesystem::path& file,
                                       const CvatOptions& options);

}  // namespace handcraft::datasets
