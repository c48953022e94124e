// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {

struct ObjectClassBenchmarkSize {
  int num_classes = 6;
  int views_per_class = 36;
  int grid_size = 50;
  int object_px = 200;  ///< side of the object's box, in a picture of 640 × 480
  int peer_folds = 12;  ///< leave-one-out: folds the peer trains; its time is extrapolated to all
  int repetitions = 3;
};

/// Leave-one-out over clouds drawn by seed (a bent surface with noise and holes for each class),
/// described by a metric grid; polynomial kernel, one against one, one thread: inner products,
/// kernel matrix and the machines of every fold. The peer is OpenCV ml, which trains each fold
/// afresh, on one thread; ours and the peer's predictions of the folds that it trained are
/// compared. Details: num_folds, num_machines, accuracy, peer_folds, same_predictions,
/// processor_seconds (of a run of ours), inner_products_ms.
BenchmarkResult BenchmarkLeaveOneOut(const BenchmarkOptions& options,
                                     const ObjectClassBenchmarkSize& size);

/// Class of one of these clouds by the runtime (hc_classify_cloud): mask and cloud of 640 × 480
/// with a whole object, features and all pairs, every view a support vector. The peer is OpenCV's
/// predict on features that are there already. Details: features_ms, num_support_vectors,
/// peer_support_vectors.
BenchmarkResult BenchmarkClassify(const BenchmarkOptions& options,
                                  const ObjectClassBenchmarkSize& size);

}  // namespace handcraft::experiments
