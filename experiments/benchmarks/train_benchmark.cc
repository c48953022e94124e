// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/train_benchmark.h"

#include <chrono>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "datasets/grasp_point_samples.h"
#include "experiments/benchmarks/peak_memory.h"
#include "experiments/benchmarks/scikit_learn_peer.h"
#include "experiments/benchmarks/training_data.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::experiments {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

struct Fit {
  double seconds = 0.0;            // median
  double processor_seconds = 0.0;  // mean a fit
  logistic::Result result;
};

Fit TrainOn(const datasets::GraspPointSamples& samples, int num_threads, int repetitions) {
  Fit fit;
  const logistic::DesignMatrix<float> X{.data = samples.features.data(),
                                        .num_samples = samples.num_samples(),
                                        .num_features = samples.num_features,
                                        .stride = samples.num_features};
  const std::clock_t start = std::clock();
  fit.seconds = 1e-3 * MedianMs(repetitions, [&] {
                  fit.result =
                      logistic::TrainLogistic(X, samples.labels, {.num_threads = num_threads});
                });
  fit.processor_seconds = static_cast<double>(std::clock() - start) /
                          static_cast<double>(CLOCKS_PER_SEC) / (repetitions + 1);
  return fit;
}

double MeanLogLoss(const logistic::Summary& summary) {
  return 0.5 * summary.deviance / static_cast<double>(summary.num_samples);
}

void MeasureOurs(const datasets::GraspPointSamples& samples,
                 int repetitions,
                 BenchmarkResult& result) {
  Fit one;
  const double peak = PeakMemoryAbove([&] { one = TrainOn(samples, 1, repetitions); });
  const Fit two = TrainOn(samples, 2, repetitions);
  const logistic::Summary& summary = one.result.summary;
  const double matrix_bytes = 4.0 * static_cast<double>(samples.features.size());
  result.ours_ms = 1e3 * one.seconds;
  result.details["num_samples"] = static_cast<double>(summary.num_samples);
  result.details["log_loss_ours"] = MeanLogLoss(summary);
  result.details["gradient_norm"] = summary.gradient_norm;
  result.details["reciprocal_condition"] = summary.reciprocal_condition;
  result.details["iterations_ours"] = summary.iterations;
  result.details["processor_seconds_ours"] = one.processor_seconds;
  result.details["seconds_2_threads"] = two.seconds;
  result.details["speedup_2_threads"] = one.seconds / two.seconds;
  result.details["peak_memory_ratio"] = (matrix_bytes + peak) / matrix_bytes;
  result.details["seconds_" + std::to_string(samples.num_features) + "_features"] = one.seconds;
}

void MeasurePeer(const datasets::GraspPointSamples& samples,
                 bool with_peer,
                 const std::filesystem::path& scratch,
                 BenchmarkResult& result) {
  std::optional<ScikitLearnFit> fit;
  if (with_peer) fit = FitWithScikitLearn(samples.features, samples.labels, scratch);
  result.peer = fit ? "scikit-learn " + fit->version + " newton-cholesky, one thread, double"
                    : "scikit-learn newton-cholesky: not run, no python3 with scikit-learn here";
  result.peer_ms = fit ? 1e3 * fit->seconds : kUnknown;
  result.details["log_loss_peer"] = fit ? fit->log_loss : kUnknown;
  result.details["iterations_peer"] = fit ? fit->iterations : kUnknown;
  result.details["processor_seconds_peer"] = fit ? fit->processor_seconds : kUnknown;
}

}  // namespace

BenchmarkResult BenchmarkTraining(const BenchmarkOptions& options, const TrainBenchmarkSize& size) {
  const ScratchFolder scratch;
  const TrainingData data(options, size.num_samples, scratch.path());
  BenchmarkResult result;
  result.dissertation_ms = 200e3;  // "between 20 and 200 seconds", section 3.3.3
  {
    const datasets::GraspPointSamples samples = data.FeaturesOf(size.features);
    Report(options.progress, "training", 0, 0);
    MeasureOurs(samples, size.repetitions, result);
    Report(options.progress, "training the peer", 0, 0);
    MeasurePeer(samples, size.with_peer, scratch.path(), result);
  }
  for (const char* preset : {"edges54", "edges150", "window180"}) {
    const datasets::GraspPointSamples samples = data.FeaturesOf(preset);
    result.details["seconds_" + std::to_string(samples.num_features) + "_features"] =
        TrainOn(samples, 1, 1).seconds;
  }
  result.ratio = result.peer_ms / result.ours_ms;
  return result;
}

BenchmarkResult BenchmarkTrainIrls(const BenchmarkOptions& options) {
  return BenchmarkTraining(options, {});
}

}  // namespace handcraft::experiments
