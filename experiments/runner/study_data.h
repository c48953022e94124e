// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/runner/grid.h"
#include "experiments/runner/study.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

/// The pictures of a study with their fingerprints (datasets::Fingerprint).
struct StudyData {
  datasets::LabelledImageSet train;
  std::string train_fingerprint = {};
  std::optional<datasets::LabelledImageSet> test = {};  ///< none: what training leaves of `train`
  /// `train` in other sizes, item by item, by their scale.
  std::map<double, datasets::LabelledImageSet> scaled = {};
  std::string test_fingerprint = {};  ///< empty without `test`
};

/// Reads the folders of the study and makes the pictures that are to be made, in folders train/ and
/// test/ below `made_folder`, and those of other sizes that its cells train on, in train_0.5/ and
/// so on; goes on with what an earlier call has made there. Throws Error as ReadLabelledImageSet
/// and MakeGraspPointSet do.
[[nodiscard]] StudyData PrepareStudyData(const Study& study,
                                         const std::filesystem::path& made_folder,
                                         int num_threads,
                                         const Progress& progress);

/// What a cell is trained on and what it is tested with.
struct CellData {
  std::vector<datasets::LabelledImageSet> train;  ///< one a size, the same items in each
  datasets::LabelledImageSet test;
};

/// Divides the pictures for a cell: by instance, class or picture, training_share of them to train
/// on and the rest to test with (AssignSplits with the cell's seed); or by the manifest's splits
/// "train" (of whose instances training_share is taken later, by sampling) and "test". When there
/// are other pictures to test with, they are all used. Throws Error when a side would be empty.
[[nodiscard]] CellData DivideForCell(const Study& study, const StudyData& data, const Cell& cell);

}  // namespace handcraft::experiments
