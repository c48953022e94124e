// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "datasets/formats/view_set.h"
#include "experiments/object_classes/object_class_training.h"
#include "trainers/svm/rejection.h"

namespace handcraft::experiments {

/// Throws Error(kBadInput) that names the first of `novel` that is not novel: a view of one of the
/// classes of `known`, of one of its instances, or with one of its clouds.
void RequireNovel(const datasets::ViewSet& novel, const datasets::ViewSet& known);

/// Sets the margin below which a view is none of the classes, by the held-out views of the training
/// and all of `novel` (svm::RejectNovel); copies of views have no part in it. Throws Error(kUsage)
/// when the training held no views out, else as datasets::DescribeViews and svm::RejectNovel do.
svm::Calibration RejectNovelViews(const datasets::ViewSet& novel,
                                  double max_false_rejection,
                                  int num_threads,
                                  ObjectClassTraining& training);

}  // namespace handcraft::experiments
