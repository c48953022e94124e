// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {

struct PcaBenchmarkSize {
  std::size_t num_samples = 154188;  ///< the dissertation's (section 3.2.1)
  const char* features = "all500";   ///< specification (lib/features/feature_spec.h)
  int repetitions = 3;               ///< of our side; the peers run once
  bool with_peer = true;
};

/// Principal components of real pixel features (squared energies) from memory: ours on two threads,
/// the peer, NumPy's cov and eigh in double, on two as well. Details: num_samples,
/// processor_seconds_* (robust when the machine is busy), seconds_1_thread, peak_memory_mb above
/// the matrix, seconds_single (products of a block in single precision) and single_error (its
/// largest error of an entry of the covariance, as a share of √(diagonal · diagonal)),
/// scikit-learn's seconds, eigenvalue_error (largest difference of ten from the peer's, as a share
/// of the largest). Those of the peers are NaN when they are not on this machine.
BenchmarkResult BenchmarkPrincipalComponents(const BenchmarkOptions& options,
                                             const PcaBenchmarkSize& size);

}  // namespace handcraft::experiments
