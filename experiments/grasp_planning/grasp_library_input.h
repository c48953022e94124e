// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/view_set.h"
#include "lib/core/progress.h"
#include "trainers/grasp_library/grasp_library.h"

namespace handcraft::experiments {

/// What a grasp library is trained on.
struct GraspLibraryInput {
  datasets::ViewSet views;                    ///< layer 2
  datasets::ViewSet shown_views;              ///< those that the poses were shown in
  datasets::DemonstrationSet demonstrations;  ///< layer 3
};

/// Reads the demonstration set, with its own views, that goes with a view set. Throws Error as its
/// readers do, and for a view without an angle and a demonstration of a class that the view set
/// does not have.
[[nodiscard]] GraspLibraryInput ReadGraspLibraryInput(datasets::ViewSet views,
                                                      const std::filesystem::path& demonstrations);

/// Describes both sets of views; classes in the order in which the view set names them, positions
/// from the mean of the cloud they were shown with. The number of threads changes nothing.
[[nodiscard]] grasp_library::TrainingSet DescribeInput(const GraspLibraryInput& input,
                                                       int num_threads,
                                                       const Progress& progress);

}  // namespace handcraft::experiments
