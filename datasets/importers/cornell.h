// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "datasets/importers/cornell_mask.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// How grasp rectangles become a label mask, and numbers become splits.
struct CornellOptions {
  double good_share = 1.0 / 3.0;  ///< central share of the opening that is good, (0, 1]
  int dont_care_margin_px = 12;   ///< nothing nearer to a rectangle than this is called bad, ≥ 0
  bool use_negative_rectangles =
      true;                ///< cneg: inside is bad, unless a positive one says otherwise
  int instance_span = 10;  ///< numbers NNNN taken as one instance: ⌊NNNN / span⌋; ≥ 1
  double test_share =
      1.0 / 3.0;       ///< share of instances, the highest numbers, put into "test"; [0, 1)
  int split_gap = 10;  ///< training pictures whose number is less than this below the first of the
                       ///< test are left out, for neighbours show the same object; ≥ 0
  int max_images = 0;  ///< keep this many, evenly spread over the pictures; 0: all
  std::string licence = "see LICENCE";
  int num_threads = 1;
  Progress progress = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;
};

/// Reads a Cornell tree (pcdNNNNr.png beside pcdNNNNcpos.txt / pcdNNNNcneg.txt, in one folder, in
/// numbered folders 01…10, or as images/ + labels/*cpos_recovered.txt) and writes a labelled image
/// set to `out`, which must not exist or be empty: images/ (copied byte for byte), masks/ and
/// manifest.csv. The class is the grasp type where the tree has a grasp_type.csv, else "object".
/// Pictures without a usable positive rectangle are left out. On failure nothing is left of it.
/// Throws Error that says what was expected and found. Same tree and options, same bytes.
LabelledImageSet ImportCornell(const std::filesystem::path& source,
                               const std::filesystem::path& out,
                               const CornellOptions& options);

}  // namespace handcraft::datasets
