// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "datasets/formats/view_set.h"
#include "experiments/object_classes/object_class_training.h"
#include "trainers/svm/rejection.h"

namespace handcraft::experiments {

/// Throws Error(kBadInput) that names the first of `novel` that is not novel to machines of these
/// classes, trained on their views in `known`: of one of the classes, or with an instance or a
/// cloud of those views.
void RequireNovel(const datasets::ViewSet& novel,
                  const datasets::ViewSet& known,
                  const std::vector<std::string>& classes);

/// Sets the margin below which a view is none of the classes, by the held-out views of the training
/// and all of `novel` (svm::RejectNovel); copies of views have no part in it. Throws Error(kUsage)
/// when the training held no views out, else as datasets::DescribeViews and svm::RejectNovel do.
svm::Calibration RejectNovelViews(const datasets::ViewSet& novel,
                                  double max_false_rejection,
                                  int num_threads,
                                  ObjectClassTraining& training);

}  // namespace handcraft::experiments
