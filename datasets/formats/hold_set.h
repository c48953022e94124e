// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/pose_columns.h"

namespace handcraft::datasets {

/// Poses of both hands at which they hold, at once, what a view shows.
struct Hold {
  std::string object_class;  ///< column "class"
  std::string instance;      ///< which physical object
  std::string view;          ///< column "image" of the view in the views.csv beside it
  EndEffectorPose right;     ///< base_from_grasp_centre of the right hand, columns right_x_m ...
  EndEffectorPose left;      ///< and of the left one, columns left_x_m ...
};

/// Holds by which the objects of a view set can be passed from hand to hand: `holds.csv` beside its
/// `views.csv`. The format is specified in docs/datasets.md.
struct HoldSet {
  std::filesystem::path root;
  std::vector<Hold> items;
};

/// Reads and checks the holds as ReadDemonstrationSet does demonstrations. Throws Error with path
/// and line.
[[nodiscard]] HoldSet ReadHoldSet(const std::filesystem::path& root);

/// Each row that ReadHoldSet would refuse and each that is there twice, with their lines, in the
/// order of the file (FindRowFaults).
[[nodiscard]] RowFindings CheckHolds(const std::filesystem::path& root);

/// Writes root/holds.csv; numbers come back as they are. Throws Error when it cannot.
void WriteHolds(const HoldSet& set);

/// SHA-256 over the sorted rows (all columns).
[[nodiscard]] std::string Fingerprint(const HoldSet& set);

}  // namespace handcraft::datasets
