// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/grasp_mask.h"
#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

/// How the Cornell data is read.
struct CornellOptions {
  GraspMaskOptions mask = {};
  bool use_negative_rectangles =
      true;                ///< cneg: inside is bad, unless a positive one says otherwise
  int instance_span = 10;  ///< numbers NNNN taken as one instance: ⌊NNNN / span⌋; ≥ 1
  int split_gap = 10;      ///< SourceSet::split_gap; ≥ 0

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Lists a Cornell tree: pcdNNNNr.png beside pcdNNNNcpos.txt / pcdNNNNcneg.txt, in one folder, in
/// numbered folders 01…10, or as images/ + labels/*cpos_recovered.txt. The class is the grasp type
/// where the tree has a grasp_type.csv, else "object". Clouds pcdNNNN.txt are kept (see
/// cornell_cloud.h), and so are the rectangles. What is left out, for
/// want of a file or of a usable positive rectangle, stands in the notes. Throws Error that says
/// what was expected and found.
[[nodiscard]] SourceSet ListCornell(const std::filesystem::path& source,
                                    const CornellOptions& options);

}  // namespace handcraft::datasets
