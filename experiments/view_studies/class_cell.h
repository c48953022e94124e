// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>

#include "datasets/object_clouds.h"
#include "experiments/view_studies/view_cell_result.h"
#include "experiments/view_studies/view_data.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

/// Feature vectors that several cells share, by what they depend on.
class DescribedViews {
 public:
  /// Those of all views of `data`, formed at the first call. `name` tells the data apart. Throws
  /// Error as datasets::DescribeViews does.
  const datasets::CloudFeatures& Of(const std::string& name,
                                    const ViewData& data,
                                    const ViewSettings& settings,
                                    int num_threads,
                                    const Progress& progress);

 private:
  std::map<std::string, datasets::CloudFeatures> features_;
};

/// Layer 1 on views: support vector machines of feature vectors of their clouds. Without `test`
/// each view is classified by machines that were trained without it; else the views of `test` are
/// classified, by the runtime, after training on all of `train`. Rows of the answers are classes,
/// groups the same and "all". Throws Error as DescribeViews and svm::TrainSvm do, and
/// Error(kNoResult) when training does not converge.
/// Source: dissertation, sections 4.2.2 and 4.3.1, Tables 4.2 to 4.4.
[[nodiscard]] ViewCellResult TellClasses(const ViewStudy& study,
                                         const ViewCell& cell,
                                         const ViewData& train,
                                         const ViewData* test,
                                         DescribedViews& described,
                                         int num_threads,
                                         const Progress& progress);

}  // namespace handcraft::experiments
