// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "experiments/view_studies/view_cell_result.h"
#include "experiments/view_studies/view_study.h"
#include "trainers/grasp_library/grasp_library.h"

namespace handcraft::experiments {

/// A hand that is turned by no more than this from the demonstrated one counts as right [deg].
inline constexpr double kRightHandDeg = 30.0;
inline constexpr double kHandBinDeg = 10.0;  ///< of the answers

/// Layer 3 on demonstrations: each is left out in turn, alone or with all that were shown in its
/// view (ViewSettings.held_out), its position is the point to grasp at, and the pose that the
/// others give is compared with its own. Class and angle are known. Rows of the answers are
/// classes, columns how far the hand is turned from the true one, in bins of kHandBinDeg, and "too
/// far" for those whose nearest demonstration is farther than ViewSettings.max_distance_m. Groups
/// and errors: the classes, then "all". The rejection curve is over that distance [m], without the
/// setting. The number of threads changes nothing. Throws Error(kBadInput) for a demonstration that
/// none is left to compare with.
/// Source: dissertation section 4.2.4, Eqs. 4.6 and 4.7; docs/methods/grasp_library.md.
[[nodiscard]] ViewCellResult FindHeldOut(const ViewCell& cell,
                                         const grasp_library::TrainingSet& shown,
                                         int num_threads);

}  // namespace handcraft::experiments
