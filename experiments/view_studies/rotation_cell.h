// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/view_set.h"
#include "experiments/view_studies/view_cell_result.h"
#include "experiments/view_studies/view_study.h"

namespace handcraft::experiments {

/// Bins of the histogram of Figure 4.7, and how wide each is.
inline constexpr std::size_t kNumRotationBins = 36;
inline constexpr double kRotationBinDeg = 10.0;

/// Layer 2 on views whose class is known: how far the angle of the most similar other view of
/// `train` is from the view's own. Without `test` the views of `train` are asked about, each
/// without itself. Rows of the answers are classes, columns differences: bin k holds those from
/// 10k − 5 to 10k + 5 degrees. Right is a difference of up to 10 degrees, of an object that half a
/// turn brings back also one of 170 to 190. Groups: the classes, then their kinds of symmetry,
/// which are the rows' kinds too: "asymmetric", "half_turn", and "symmetry unknown" where the set
/// does not say, which is judged as asymmetric.
/// Objects that are round, and views without angle, are left out (dissertation, section 4.3.2).
/// Throws Error(kBadInput) for a view that cannot be described, and when nothing is left.
[[nodiscard]] ViewCellResult FindRotations(const ViewCell& cell,
                                           const datasets::ViewSet& train,
                                           const datasets::ViewSet* test,
                                           int num_threads);

/// The bin of a difference of angles [deg].
[[nodiscard]] std::size_t RotationBin(double difference_deg) noexcept;

/// Whether a difference counts as right for an object of this symmetry, as a view set has it.
[[nodiscard]] bool IsRightRotation(double difference_deg, std::string_view symmetry) noexcept;

}  // namespace handcraft::experiments
