// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"

namespace handcraft::datasets {

/// How grasp rectangles become a label mask, and numbers become splits.
struct CornellOptions {
  double good_share = 1.0 / 3.0;  ///< central share of the opening that is good, (0, 1]
  int dont_care_margin_px = 12;   ///< nothing nearer to a rectangle than this is called bad, ≥ 0
  bool use_negative_rectangles =
      true;                       ///< cneg: inside is bad, unless a positive one says otherwise
  int instance_span = 1;          ///< consecutive pictures (by number) taken as one instance, ≥ 1
  double test_share = 1.0 / 3.0;  ///< share of instances, the highest numbers, put into "test"
  int max_images = 0;             ///< keep this many, evenly spread over the numbers; 0: all
  std::string licence = "see LICENCE";

  void Validate() const;
};

/// A rectangle as four corners [px], in the order of the original files: the edge from corner 0 to
/// corner 1 is the direction the gripper opens.
using GraspRectangle = std::array<std::array<double, 2>, 4>;

/// Reads `pcdNNNNcpos.txt`-like files: four lines "x y" a rectangle. Rectangles with NaN corners
/// (the original has some) are left out; anything else that is wrong throws Error with the line.
[[nodiscard]] std::vector<GraspRectangle> ReadCornellRectangles(const std::filesystem::path& path);

/// The mask of one picture by the policy above.
[[nodiscard]] Image MakeCornellMask(int width,
                                    int height,
                                    const std::vector<GraspRectangle>& positive,
                                    const std::vector<GraspRectangle>& negative,
                                    const CornellOptions& options);

/// Reads a Cornell tree (pcdNNNNr.png beside pcdNNNNcpos.txt / pcdNNNNcneg.txt, in one folder, in
/// numbered folders 01…10, or as images/ + labels/*cpos_recovered.txt) and writes a labelled image
/// set to `out`, which must not exist or be empty. On failure nothing is left of it. Throws Error
/// that says what was expected and found.
LabelledImageSet ImportCornell(const std::filesystem::path& source,
                               const std::filesystem::path& out,
                               const CornellOptions& options);

}  // namespace handcraft::datasets
