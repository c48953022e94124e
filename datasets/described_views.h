// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "datasets/formats/view_set.h"
#include "lib/core/progress.h"
#include "lib/features/object_rotation.h"

namespace handcraft::datasets {

/// The cloud and mask of a view as features take them; the view must outlive it and have a cloud.
[[nodiscard]] features::ObjectCloud ObjectCloudOf(const LoadedView& view);

/// Plane, mean and moments of each view of a set, in its order: what layer 2 of grasp synthesis
/// compares (features::DescribeView). The number of threads changes nothing. Throws Error naming
/// the file: a view without a cloud, or one that no plane fits or whose mask has no halves; and
/// those of ReadView.
[[nodiscard]] std::vector<features::ViewDescription> DescribeViews(const ViewSet& set,
                                                                   int num_threads,
                                                                   const Progress& progress);

}  // namespace handcraft::datasets
