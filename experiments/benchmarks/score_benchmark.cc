// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include <opencv2/core.hpp>

#include "experiments/benchmarks/benchmark.h"
#include "experiments/benchmarks/fma_peak.h"
#include "experiments/benchmarks/opencv_scorers.h"
#include "lib/core/check.h"
#include "lib/core/rng.h"
#include "lib/features/pixel_scorer.h"

namespace handcraft::experiments {
namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

// Ramps, waves and noise; the time of a score does not depend on what the picture shows.
Image MakePicture(int channels) {
  Rng rng = Rng::Stream(1, "score_benchmark");
  Image image(kWidth, kHeight, channels);
  for (int v = 0; v < kHeight; ++v) {
    for (int x = 0; x < kWidth * channels; ++x) {
      const double value = 120.0 + 60.0 * std::sin(0.02 * x + 0.03 * v) + 10.0 * rng.Normal();
      image.Row(v)[x] = static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0));
    }
  }
  return image;
}

std::vector<float> MakeWeights(int count) {
  Rng rng = Rng::Stream(1, "score_benchmark_weights");
  std::vector<float> weights(static_cast<std::size_t>(count));
  for (float& weight : weights) weight = static_cast<float>(0.02 * rng.Normal());
  return weights;
}

features::RawImage RawView(const Image& image) {
  const int channels = image.channels();
  return {image.Row(0),
          kWidth,
          kHeight,
          std::ptrdiff_t{kWidth} * channels,
          channels == 1 ? features::PixelFormat::kGray8 : features::PixelFormat::kBgr8};
}

// A scorer with its memory.
class TimedScorer {
 public:
  TimedScorer(const features::FeatureSpec& spec,
              std::span<const float> weights,
              features::InstructionSet set)
      : scorer_(spec, weights, kIntercept, set),
        size_(scorer_.WorkspaceBytes(kWidth, kHeight)),
        memory_(static_cast<std::byte*>(::operator new (size_, std::align_val_t{64}))),
        probabilities_(kWidth, kHeight) {}

  double MedianScoreMs(const Image& image, int repetitions) {
    return MedianMs(repetitions, [&] {
      scorer_.Score(RawView(image), {memory_.get(), size_}, probabilities_.Row(0), kWidth);
    });
  }
  [[nodiscard]] const FloatImage& probabilities() const { return probabilities_; }

  static constexpr float kIntercept = 0.1F;

 private:
  struct Free {
    void operator()(std::byte* p) const { ::operator delete (p, std::align_val_t{64}); }
  };
  features::PixelScorer scorer_;
  std::size_t size_;
  std::unique_ptr<std::byte, Free> memory_;
  FloatImage probabilities_;
};

double WorstDifference(const FloatImage& a, const FloatImage& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.values().size(); ++i) {
    worst = std::max(
        worst, std::abs(static_cast<double>(a.values()[i]) - static_cast<double>(b.values()[i])));
  }
  return worst;
}

// What is scored, and by what.
struct Task {
  features::FeatureSpec spec;
  std::vector<float> weights;
  Image gray;
  int repetitions = 1;
};

// OpenCV's two ways on one thread, and what they found.
struct Peers {
  double gather_ms = 0.0;
  double convolutions_ms = 0.0;
  FloatImage gathered;
  FloatImage convolved;
};

Peers TimePeers(const Task& task) {
  Peers peers;
  const int previous_threads = cv::getNumThreads();
  cv::setNumThreads(1);
  peers.gather_ms = MedianMs(std::max(1, task.repetitions / 5), [&] {
    peers.gathered = ScoreByGathering(task.gray, task.spec, task.weights, TimedScorer::kIntercept);
  });
  peers.convolutions_ms = MedianMs(task.repetitions, [&] {
    peers.convolved =
        ScoreByConvolutions(task.gray, task.spec, task.weights, TimedScorer::kIntercept);
  });
  cv::setNumThreads(previous_threads);
  return peers;
}

// With other instruction sets, and with another energy.
void AddVariantTimes(const Task& task, BenchmarkResult& result) {
  const std::span<const features::InstructionSet> sets = features::SupportedInstructionSets();
  for (const features::InstructionSet set : sets) {
    if (set == features::InstructionSet::kBaseline) continue;
    result.details[std::string(NameOf(set)) + "_ms"] =
        TimedScorer(task.spec, task.weights, set).MedianScoreMs(task.gray, task.repetitions);
  }
  features::FeatureSpec log_spec = task.spec;
  log_spec.energy = features::Energy::kLog;
  result.details["log_energy_ms"] =
      TimedScorer(log_spec, task.weights, sets.back()).MedianScoreMs(task.gray, task.repetitions);
}

// Each time a median of its own calls; ours before and after the peers, so that a drifting clock
// shows.
BenchmarkResult BenchmarkScore(const char* spec_text, const BenchmarkOptions& options) {
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  const Task task{spec, MakeWeights(spec.NumFeatures()), MakePicture(1), options.repetitions};
  const features::InstructionSet best = features::SupportedInstructionSets().back();
  TimedScorer ours(spec, task.weights, best);

  BenchmarkResult result;
  const double before_ms = ours.MedianScoreMs(task.gray, task.repetitions);
  const Peers peers = TimePeers(task);
  const double after_ms = ours.MedianScoreMs(task.gray, task.repetitions);

  result.ours_ms = std::max(before_ms, after_ms);
  result.peer = "OpenCV filter2D for each filter, gather, dot product";
  result.peer_ms = peers.gather_ms;
  result.ratio = result.peer_ms / result.ours_ms;
  const double fmas = double{kWidth} * kHeight * spec.NumFeatures();
  const double peak = MeasureFmaPeak(best);
  result.details = {
      {"peer_convolutions_ms", peers.convolutions_ms},
      {"ratio_convolutions", peers.convolutions_ms / result.ours_ms},
      {"worst_difference_gather", WorstDifference(ours.probabilities(), peers.gathered)},
      {"worst_difference_convolutions", WorstDifference(ours.probabilities(), peers.convolved)},
      {"fma_peak_gflops", 2e-9 * peak},
      {"share_of_fma_peak", fmas / (1e-3 * result.ours_ms) / peak},
      {"bgr_ms", ours.MedianScoreMs(MakePicture(3), task.repetitions)},
  };
  AddVariantTimes(task, result);
  return result;
}

}  // namespace

BenchmarkResult BenchmarkScoreAll500Vga(const BenchmarkOptions& options) {
  BenchmarkResult result = BenchmarkScore("all500", options);
  result.dissertation_ms = 8000.0;  // section 3.3.3, Figure 3.10
  return result;
}

BenchmarkResult BenchmarkScoreEdges54Vga(const BenchmarkOptions& options) {
  BenchmarkResult result = BenchmarkScore("edges54", options);
  result.dissertation_ms = 1000.0;  // section 3.3.3
  return result;
}

}  // namespace handcraft::experiments
