// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {

struct TrainBenchmarkSize {
  std::size_t num_samples = 154188;  ///< the dissertation's (section 3.3)
  const char* features = "all500";   ///< specification (lib/features/feature_spec.h)
  int repetitions = 3;               ///< of our side; the peer runs once
  bool with_peer = true;
};

/// Trains logistic regression on real pixel features (squared energies, from the pictures
/// of options.dataset and as many of their mirror images as it takes) from memory: ours on one and
/// on two threads, the peer on the same matrix with one. ours_ms and peer_ms are wall times of the
/// fit. Details: num_samples; log_loss_* (mean), gradient_norm (a sample), iterations_*,
/// processor_seconds_* (robust when the machine is busy), two threads and their speed-up,
/// peak_memory_ratio ((matrix + peak above it) / matrix), seconds_54_features … _500 (the line of
/// Figure 3.11). Those of the peer are NaN when it is not on this machine.
BenchmarkResult BenchmarkTraining(const BenchmarkOptions& options, const TrainBenchmarkSize& size);

}  // namespace handcraft::experiments
