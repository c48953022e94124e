// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include "experiments/benchmarks/benchmark.h"

namespace handcraft::experiments {

struct InverseKinematicsBenchmarkSize {
  std::size_t num_poses = 100000;
  std::size_t num_peer_poses = 100000;  ///< the first of them, for KDL's quicker ways
  std::size_t num_slow_poses = 5000;    ///< the first of them, for its slow one
};

/// Inverse kinematics of a Barrett WAM: forward kinematics of joint values drawn within the limits
/// gives poses; ours returns every solution of a sweep of 4 degrees. ours_ms and peer_ms are
/// processor time a pose, the peer's one call of KDL's Levenberg-Marquardt solver from the middle
/// of the limits. Details: shares of the poses that were solved within the limits and 1e-6 m and
/// rad (ours: 1e-9), µs a pose (also the slowest, and by instruction set), solutions a pose, the
/// largest errors of all our solutions; for KDL its three ways: one Levenberg-Marquardt call, one
/// Newton-Raphson call with limits, and our iterative solver, which starts the former again until
/// it succeeds.
BenchmarkResult BenchmarkInverseKinematicsOf(const InverseKinematicsBenchmarkSize& size);

}  // namespace handcraft::experiments
