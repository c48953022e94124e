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

// Each time a median of its own calls; ours before and after the peers, so that a drifting clock
// shows.
BenchmarkResult BenchmarkScore(const char* spec_text, const BenchmarkOptions& options) {
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  const std::vector<float> weights = MakeWeights(spec.NumFeatures());
  const Image gray = MakePicture(1);
  const Image bgr = MakePicture(3);
  const features::InstructionSet best = features::SupportedInstructionSets().back();
  TimedScorer ours(spec, weights, best);

  BenchmarkResult result;
  const double before_ms = ours.MedianScoreMs(gray, options.repetitions);
  const int previous_threads = cv::getNumThreads();
  cv::setNumThreads(1);
  FloatImage gathered;
  FloatImage convolved;
  const int peer_repetitions = std::max(1, options.repetitions / 5);
  result.peer_ms = MedianMs(peer_repetitions, [&] {
    gathered = ScoreByGathering(gray, spec, weights, TimedScorer::kIntercept);
  });
  const double convolutions_ms = MedianMs(options.repetitions, [&] {
    convolved = ScoreByConvolutions(gray, spec, weights, TimedScorer::kIntercept);
  });
  cv::setNumThreads(previous_threads);
  const double after_ms = ours.MedianScoreMs(gray, options.repetitions);

  result.ours_ms = std::max(before_ms, after_ms);
  result.peer = "OpenCV filter2D for each filter, gather, dot product";
  result.ratio = result.peer_ms / result.ours_ms;
  const double fmas = double{kWidth} * kHeight * spec.NumFeatures();
  const double peak = MeasureFmaPeak(best);
  result.details = {
      {"peer_convolutions_ms", convolutions_ms},
      {"ratio_convolutions", convolutions_ms / result.ours_ms},
      {"worst_difference_gather", WorstDifference(ours.probabilities(), gathered)},
      {"worst_difference_convolutions", WorstDifference(ours.probabilities(), convolved)},
      {"fma_peak_gflops", 2e-9 * peak},
      {"share_of_fma_peak", fmas / (1e-3 * result.ours_ms) / peak},
      {"bgr_ms", ours.MedianScoreMs(bgr, options.repetitions)},
  };
  for (const features::InstructionSet set : features::SupportedInstructionSets()) {
    if (set == features::InstructionSet::kBaseline) continue;
    result.details[std::string(NameOf(set)) + "_ms"] =
        TimedScorer(spec, weights, set).MedianScoreMs(gray, options.repetitions);
  }
  features::FeatureSpec log_spec = spec;
  log_spec.energy = features::Energy::kLog;
  result.details["log_energy_ms"] =
      TimedScorer(log_spec, weights, best).MedianScoreMs(gray, options.repetitions);
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
