// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/pca_benchmark.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "datasets/formats/npy.h"
#include "experiments/benchmarks/peak_memory.h"
#include "experiments/benchmarks/peer_scripts.h"
#include "experiments/benchmarks/python_peer.h"
#include "experiments/benchmarks/training_data.h"
#include "trainers/pca/pca.h"

namespace handcraft::experiments {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kNumThreads = 2;

struct Timing {
  double seconds = 0.0;            // median
  double processor_seconds = 0.0;  // mean
};

Timing TimeOf(int repetitions, const std::function<void()>& call) {
  const std::clock_t start = std::clock();
  Timing timing{.seconds = 1e-3 * MedianMs(repetitions, call)};
  timing.processor_seconds = static_cast<double>(std::clock() - start) /
                             static_cast<double>(CLOCKS_PER_SEC) / (repetitions + 1);
  return timing;
}

double LargestError(const Scatter& actual, const Scatter& expected) {
  const std::size_t p = expected.num_features;
  double largest = 0.0;
  for (std::size_t i = 0; i < p; ++i) {
    for (std::size_t j = 0; j < p; ++j) {
      const double size = std::sqrt(expected.products[i * p + i] * expected.products[j * p + j]);
      const double error = std::abs(actual.products[i * p + j] - expected.products[i * p + j]);
      if (size > 0.0) largest = std::max(largest, error / size);
    }
  }
  return largest;
}

std::vector<double> MeasureOurs(const DesignMatrix<float>& X,
                                int repetitions,
                                BenchmarkResult& result) {
  pca::Result ours;
  Timing two;
  const double peak = PeakMemoryAbove([&] {
    two = TimeOf(repetitions, [&] { ours = pca::TrainPca(X, {.num_threads = kNumThreads}); });
  });
  const Timing one = TimeOf(1, [&] { ours = pca::TrainPca(X, {.num_threads = 1}); });
  const Timing single = TimeOf(repetitions, [&] {
    ours = pca::TrainPca(X, {.precision = ScatterPrecision::kSingle, .num_threads = kNumThreads});
  });
  const Scatter in_double = ComputeScatter(X, {}, 1, {.num_threads = kNumThreads});
  const Scatter in_single = ComputeScatter(
      X, {}, 1, {.precision = ScatterPrecision::kSingle, .num_threads = kNumThreads});
  result.ours_ms = 1e3 * two.seconds;
  result.details["num_samples"] = static_cast<double>(X.num_samples);
  result.details["processor_seconds_ours"] = two.processor_seconds;
  result.details["seconds_1_thread"] = one.seconds;
  result.details["peak_memory_mb"] = 1e-6 * peak;
  result.details["seconds_single"] = single.seconds;
  result.details["processor_seconds_single"] = single.processor_seconds;
  result.details["single_error"] = LargestError(in_single, in_double);
  return pca::PcaOfScatter(in_double, std::vector<double>(X.num_features, 1.0)).eigenvalues;
}

void MeasurePeer(const datasets::GraspPointSamples& samples,
                 bool with_peer,
                 const std::vector<double>& eigenvalues,
                 BenchmarkResult& result) {
  std::optional<nlohmann::json> peer;
  if (with_peer) {
    const ScratchFolder scratch;
    const std::filesystem::path file = scratch.path() / "features.npy";
    datasets::WriteNpy(file, samples.features.data(), samples.num_samples(), samples.num_features);
    peer = RunPythonPeer(kPrincipalComponentsScript, {file}, scratch.path(), kNumThreads);
  }
  const auto figure = [&](const char* key) {
    return peer ? peer->at(key).get<double>() : kUnknown;
  };
  result.peer = peer ? "NumPy " + peer->at("version").get<std::string>() +
                           " cov and eigh, two threads, double"
                     : "NumPy cov and eigh: not run, no python3 with scikit-learn here";
  result.peer_ms = 1e3 * figure("seconds");
  result.details["processor_seconds_peer"] = figure("processor_seconds");
  result.details["seconds_scikit_learn"] = figure("sklearn_seconds");
  result.details["processor_seconds_scikit_learn"] = figure("sklearn_processor_seconds");
  double error = peer ? 0.0 : kUnknown;
  for (std::size_t k = 0; peer && k < peer->at("largest_eigenvalues").size(); ++k) {
    const double expected = peer->at("largest_eigenvalues")[k];
    error = std::max(error, std::abs(eigenvalues[k] - expected) / eigenvalues[0]);
  }
  result.details["eigenvalue_error"] = error;
}

}  // namespace

BenchmarkResult BenchmarkPrincipalComponents(const BenchmarkOptions& options,
                                             const PcaBenchmarkSize& size) {
  const ScratchFolder scratch;
  const datasets::GraspPointSamples samples =
      TrainingData(options, size.num_samples, scratch.path()).FeaturesOf(size.features);
  const DesignMatrix<float> X{.data = samples.features.data(),
                              .num_samples = samples.num_samples(),
                              .num_features = samples.num_features,
                              .stride = samples.num_features};
  BenchmarkResult result;
  result.dissertation_ms = kUnknown;
  Report(options.progress, "principal components", 0, 0);
  const std::vector<double> eigenvalues = MeasureOurs(X, size.repetitions, result);
  Report(options.progress, "principal components of the peer", 0, 0);
  MeasurePeer(samples, size.with_peer, eigenvalues, result);
  result.ratio = result.peer_ms / result.ours_ms;
  return result;
}

BenchmarkResult BenchmarkPca(const BenchmarkOptions& options) {
  return BenchmarkPrincipalComponents(options, {});
}

}  // namespace handcraft::experiments
