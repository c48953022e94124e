// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/formats/view_set.h"
#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

/// As ImportPictures, of views: writes a view set, images/, object_masks/ (what make_mask returns:
/// kObject and kNoObject alone), clouds/ where there are any, and views.csv. A view in which no
/// object is seen is left out, told in a note; splits are dealt out before. Throws Error when no
/// view is left.
ViewSet ImportViews(SourceSet source,
                    const std::filesystem::path& out,
                    const ImportOptions& options);

}  // namespace handcraft::datasets
