// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/benchmark.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "lib/core/check.h"

namespace handcraft::experiments {

namespace {

constexpr std::array kBenchmarks = {
    Benchmark{.name = "score_all500_vga",
              .what = "probability of every pixel of a 640x480 picture, 500 features, one core",
              .run = &BenchmarkScoreAll500Vga,
              .target_ms = 12.0,
              .reads_repetitions = true},
    Benchmark{.name = "score_edges54_vga",
              .what = "probability of every pixel of a 640x480 picture, 54 features, one core",
              .run = &BenchmarkScoreEdges54Vga,
              .target_ms = 2.0,
              .reads_repetitions = true},
    Benchmark{.name = "search_space_vga",
              .what = "from a 640x480 cloud and picture to ranked grasp points on the object's "
                      "edges, 180 features, one core",
              .run = &BenchmarkSearchSpaceVga,
              .target_ms = 12.0,
              .reads_repetitions = true},
    Benchmark{.name = "load_model",
              .what = "load a 500-feature model: checksum, verification, self-test",
              .run = &BenchmarkLoadModel,
              .target_ms = 1.0,
              .reads_repetitions = true},
    Benchmark{.name = "train_irls_154188x500",
              .what = "logistic regression on 154188 samples with 500 pixel features in memory, "
                      "one core",
              .run = &BenchmarkTrainIrls,
              .reads_dataset = true},
    Benchmark{.name = "pca_154188x500",
              .what = "principal components of 154188 samples with 500 pixel features in memory, "
                      "two threads",
              .run = &BenchmarkPca,
              .target_ms = 2000.0,
              .reads_dataset = true},
    Benchmark{.name = "inverse_kinematics",
              .what = "every solution of a 4-degree sweep for a pose of a 7-joint Barrett WAM, "
                      "100000 poses, one core",
              .run = &BenchmarkInverseKinematics,
              .target_ms = 0.2},
    Benchmark{.name = "svm_leave_one_out_216x7500",
              .what = "support vector machines of 6 classes, one against one, for each of the 216 "
                      "clouds left out, 7500 features in memory, one core",
              .run = &BenchmarkSvmLeaveOneOut,
              .target_ms = 3000.0},
    Benchmark{.name = "classify_cloud_grid50",
              .what = "class of an object of 200x200 px in a 640x480 cloud: 7500 features, 15 "
                      "pairs over 216 support vectors, one core",
              .run = &BenchmarkClassifyCloud,
              .target_ms = 0.7,
              .reads_repetitions = true},
    Benchmark{.name = "rotation_layer",
              .what = "plane, moments and the most similar of 36 views, 640x480 cloud with an "
                      "object of some 10000 points, one core",
              .run = &BenchmarkRotationLayer,
              .reads_repetitions = true},
    Benchmark{.name = "nearest_demonstration",
              .what = "nearest of 5607 demonstrated positions, one core",
              .run = &BenchmarkNearestDemonstration,
              .reads_repetitions = true},
};

}  // namespace

std::span<const Benchmark> AllBenchmarks() { return kBenchmarks; }

double MedianMs(int repetitions, const std::function<void()>& call) {
  HC_CHECK(repetitions >= 1, repetitions);
  using Clock = std::chrono::steady_clock;
  std::vector<double> times_ms;
  call();
  for (int i = 0; i < repetitions; ++i) {
    const Clock::time_point start = Clock::now();
    call();
    times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  const auto middle = times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2);
  std::nth_element(times_ms.begin(), middle, times_ms.end());
  return *middle;
}

}  // namespace handcraft::experiments
