// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/importers/image_set_import.h"
#include "datasets/importers/label_roles.h"

namespace handcraft::datasets {

/// What the affordances of the UMD data mean where nothing else is said: parts made to be held.
[[nodiscard]] LabelRoles UmdRoles();

/// Lists a tree of the UMD Part Affordance Dataset: NAME_rgb.jpg (or .png …) beside
/// NAME_label.mat, at any depth; without the latter (cluttered scenes) NAME_label_rank.mat. The
/// labels are the affordances grasp, cut, scoop, contain, pound, support and wrap-grasp, the
/// numbers 1 … 7 of the matrix `gt_label`; 0 has none. Of ranked affordances (rows × columns × 7, 1
/// the first, 0 none) the first counts. The folder's name is the instance, what stands before its
/// number the class: mug_01. What has no partner is left out and stands in the notes. Throws Error
/// that says what was expected and found when there is no such pair, or a matrix holds other values
/// or has another size. Source:
/// A. Myers, C. L. Teo, C. Fermüller, Y. Aloimonos, "Affordance detection of tool parts from
/// geometric features", ICRA 2015, and its data's description.
[[nodiscard]] SourceSet ListUmd(const std::filesystem::path& source, const LabelRoles& roles);

}  // namespace handcraft::datasets
