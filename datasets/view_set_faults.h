// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "datasets/formats/fault.h"
#include "datasets/formats/view_set.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// What `handcraft data check` prints of a view set: opens its pictures, masks and clouds and names
/// each fault, in the order of views.csv; nothing when all is well. Files that cannot be read or do
/// not fit each other, views in which no object or no point of it is seen (legal, but useless), and
/// pictures that are there twice. Same set, same faults for any number of threads.
[[nodiscard]] std::vector<Fault> FindFaults(const ViewSet& set,
                                            int num_threads = 1,
                                            const Progress& progress = {});

}  // namespace handcraft::datasets
