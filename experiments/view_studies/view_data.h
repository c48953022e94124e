// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

#include "datasets/formats/view_set.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

/// The views of a source as one set. Made sets lie in folders below `made_folder`, which is then
/// the set's own; of several sets (ViewSource::num_sets) a class is "drill 2". Goes on with what an
/// earlier call has made there. A demonstration set (ViewSource::num_poses) keeps its own folder.
/// Throws Error as ReadViewSet and MakeViewSet do.
[[nodiscard]] datasets::ViewSet ProvideViews(const ViewSource& source,
                                             const std::filesystem::path& made_folder,
                                             int num_threads,
                                             const Progress& progress);

/// The views of the first classes of a set alone; all when `num_classes` is 0. Throws Error(kUsage)
/// when there are fewer.
[[nodiscard]] datasets::ViewSet OnlyFirstClasses(const datasets::ViewSet& set,
                                                 std::size_t num_classes);

}  // namespace handcraft::experiments
