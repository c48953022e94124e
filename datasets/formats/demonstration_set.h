// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/pose_columns.h"

namespace handcraft::datasets {

/// A pose of the hand at which it can grasp what a view shows: base_from_grasp_centre. The grasp
/// centre is the point between the fingertips, z the approach axis (from the palm to the object),
/// x the closing axis (along which the fingers close).
struct Demonstration {
  std::string object_class;         ///< column "class"
  std::string instance;             ///< which physical object
  std::string view;                 ///< column "image" of the view in the views.csv beside it
  std::optional<double> angle_deg;  ///< of the object about z in that view; none where unknown
  EndEffectorPose pose;             ///< frame "base", end-effector "grasp_centre"
};

/// Poses shown to a robot for the views of a view set: `demonstrations.csv` beside its `views.csv`.
/// The format is specified in docs/datasets.md.
struct DemonstrationSet {
  std::filesystem::path root;
  std::vector<Demonstration> items;
};

/// Reads and checks the demonstrations: columns, numbers, quaternions, frames; each view stands in
/// views.csv with the same class, instance and angle. Throws Error with path and line. Neither
/// pictures nor clouds are opened.
[[nodiscard]] DemonstrationSet ReadDemonstrationSet(const std::filesystem::path& root);

/// Each row that ReadDemonstrationSet would refuse and each that is there twice, with their lines,
/// in the order of the file (FindRowFaults).
[[nodiscard]] RowFindings CheckDemonstrations(const std::filesystem::path& root);

/// Writes root/demonstrations.csv; numbers come back as they are. Throws Error when it cannot.
void WriteDemonstrations(const DemonstrationSet& set);

/// SHA-256 over the sorted rows (all columns): same demonstrations, same text, wherever the folder
/// lies and however its rows are ordered. The views have a fingerprint of their own.
[[nodiscard]] std::string Fingerprint(const DemonstrationSet& set);

}  // namespace handcraft::datasets
