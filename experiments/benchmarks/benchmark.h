// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "lib/core/progress.h"

namespace handcraft::experiments {

struct BenchmarkOptions {
  std::filesystem::path dataset =
      "datasets/samples/cornell_mini";  ///< real pictures, where one is needed
  int repetitions = 15;                 ///< of the quick ones; slow ones say how often they run
  Progress progress = {};
};

/// One claim, measured beside its peer in one run. Times are medians.
struct BenchmarkResult {
  std::string name;  ///< stable, "score_all500_vga"
  std::string what;
  double dissertation_ms = 0.0;                                 ///< NaN: the text gives none
  double target_ms = std::numeric_limits<double>::quiet_NaN();  ///< of the benchmark
  std::string peer;
  double peer_ms = 0.0;  ///< NaN: the peer is not on this machine
  double ours_ms = 0.0;
  double ratio = 0.0;  ///< peer_ms / ours_ms
  std::string unit = "ms";
  std::map<std::string, double> details;
};

struct Benchmark {
  std::string_view name;
  std::string_view what;
  BenchmarkResult (*run)(const BenchmarkOptions& options);
  /// At most so long, as was promised; NaN: nothing was. Of one pose or picture where that is
  /// timed.
  double target_ms = std::numeric_limits<double>::quiet_NaN();
  bool reads_dataset = false;      ///< of the options
  bool reads_repetitions = false;  ///< of the options
};

/// Every speed that the documents claim.
[[nodiscard]] std::span<const Benchmark> AllBenchmarks();

/// Median time of one call [ms], after one call that is not counted.
[[nodiscard]] double MedianMs(int repetitions, const std::function<void()>& call);

BenchmarkResult BenchmarkScoreAll500Vga(const BenchmarkOptions& options);
BenchmarkResult BenchmarkScoreEdges54Vga(const BenchmarkOptions& options);
BenchmarkResult BenchmarkLoadModel(const BenchmarkOptions& options);
BenchmarkResult BenchmarkTrainIrls(const BenchmarkOptions& options);
BenchmarkResult BenchmarkPca(const BenchmarkOptions& options);
BenchmarkResult BenchmarkSearchSpaceVga(const BenchmarkOptions& options);
BenchmarkResult BenchmarkInverseKinematics(const BenchmarkOptions& options);
BenchmarkResult BenchmarkSvmLeaveOneOut(const BenchmarkOptions& options);
BenchmarkResult BenchmarkClassifyCloud(const BenchmarkOptions& options);
BenchmarkResult BenchmarkRotationLayer(const BenchmarkOptions& options);
BenchmarkResult BenchmarkNearestDemonstration(const BenchmarkOptions& options);

}  // namespace handcraft::experiments
