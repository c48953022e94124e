// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Scoring a whole 640 × 480 picture: preset, energy and instruction set one by one.

#include <cstddef>
#include <new>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/micro_benchmarks/random_picture.h"
#include "lib/features/pixel_scorer.h"

namespace handcraft::experiments {
namespace {

void Score(benchmark::State& state, const std::string& spec_text, features::InstructionSet set) {
  const Image image = RandomPicture(3);
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  const std::vector<float> weights(spec.NumFeatures(), 0.01F);
  const features::PixelScorer scorer(spec, weights, 0.1, set);
  const std::size_t size = scorer.WorkspaceBytes(image.width(), image.height());
  auto* const workspace = static_cast<std::byte*>(::operator new (size, std::align_val_t{64}));
  FloatImage probabilities(image.width(), image.height());
  const features::RawImage raw{image.Row(0),
                               image.width(),
                               image.height(),
                               std::ptrdiff_t{3} * image.width(),
                               features::PixelFormat::kBgr8};
  for (auto iteration : state) {
    scorer.Score(raw, {workspace, size}, probabilities.Row(0), image.width());
    benchmark::ClobberMemory();
  }
  ::operator delete (workspace, std::align_val_t{64});
  const double num_pixels =
      static_cast<double>(state.iterations()) * image.width() * image.height();
  state.counters["features_per_second"] = benchmark::Counter(
      num_pixels * static_cast<double>(spec.NumFeatures()), benchmark::Counter::kIsRate);
}

const bool kRegistered = [] {
  for (const char* preset : {"all500", "edges150", "window180", "edges54", "saxena459"}) {
    for (const char* energy : {"square", "abs", "log"}) {
      const std::string spec = std::string(preset) + ",energy=" + energy;
      for (const features::InstructionSet set : features::SupportedInstructionSets()) {
        const std::string name = "Score/" + spec + "/" + std::string(features::NameOf(set));
        benchmark::RegisterBenchmark(name.c_str(), Score, spec, set)->Unit(benchmark::kMillisecond);
      }
    }
  }
  return true;
}();

}  // namespace
}  // namespace handcraft::experiments
