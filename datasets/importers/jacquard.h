// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <vector>

#include "datasets/importers/grasp_mask.h"
#include "datasets/importers/image_set_import.h"

namespace handcraft::datasets {

/// Reads a `*_grasps.txt` of the Jacquard data: a line `x;y;theta;opening;jaw` a grasp, in pixels
/// and degrees; theta turns the opening from the u axis towards the v axis. Grasps with less than
/// one square pixel are left out; anything else that is wrong throws Error with the line.
[[nodiscard]] std::vector<GraspRectangle> ReadJacquardGrasps(const std::filesystem::path& path);

/// Lists a Jacquard tree: N_OBJECT_RGB.png beside N_OBJECT_grasps.txt, at any depth. OBJECT is the
/// instance, the class is "object". What is left out, for want of a file or of a usable grasp,
/// stands in the notes. Throws Error that says what was expected and found. Source: A. Depierre, E.
/// Dellandréa, L. Chen, "Jacquard", IROS 2018, and its data's description.
[[nodiscard]] SourceSet ListJacquard(const std::filesystem::path& source,
                                     const GraspMaskOptions& options);

}  // namespace handcraft::datasets
