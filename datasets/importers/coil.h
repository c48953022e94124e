// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

struct CoilOptions {
  int threshold = 0;  ///< values up to this are dark: background where they reach the edge; 0 … 255
  bool flat_clouds = false;  ///< views get clouds of their silhouettes (FlatCloudOf)

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Lists the views of COIL-20 or COIL-100: objN__K.png, at any depth. In COIL-20 K counts steps of
/// 5° (0 … 71), in COIL-100 it is the angle [deg]; the latter is taken when a K is above 71. objN
/// is instance and class. A source that is an NPY file of bytes (pictures × rows × columns) holds
/// the 72 views of each object in the order of their angles, object after object. The masks are
/// made by MaskBeforeDarkness; no clouds were measured. Throws Error when there is no such view,
/// and for another number of pictures. Source: S. A. Nene, S. K. Nayar, H. Murase, "Columbia object
/// image library (COIL-20)", CUCS-005-96 and "(COIL-100)", CUCS-006-96.
[[nodiscard]] SourceSet ListCoil(const std::filesystem::path& source, const CoilOptions& options);

}  // namespace handcraft::datasets
