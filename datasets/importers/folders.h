// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

/// Where pictures and masks lie, and what the values of a mask mean.
struct FoldersOptions {
  std::string images = "images";  ///< folder of the pictures, below the source
  std::string masks = "masks";    ///< folder of the masks; may be the same one
  std::string image_suffix = {};  ///< end of a picture's name before the extension: "_rgb"
  std::string mask_suffix = {};   ///< the same of a mask: "_label"
  std::vector<int> good = {};  ///< values that mean good, 0 … 255; empty: all but 0 and don't care
  std::vector<int> dont_care = {};  ///< values that mean don't care

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Lists pairs of picture and mask: the same path below the two folders once suffix and extension
/// are taken off. A mask is a file of any lossless kind that ReadImage takes, gray or with equal
/// channels; values that are neither good nor don't care are bad. Each picture is an instance of
/// its own; the class is its first folder below `images`, else "object". What has no partner
/// is left out and stands in the notes. Throws Error when two have the same one, or there is none.
[[nodiscard]] SourceSet ListFolders(const std::filesystem::path& source,
                                    const FoldersOptions& options);

}  // namespace handcraft::datasets
