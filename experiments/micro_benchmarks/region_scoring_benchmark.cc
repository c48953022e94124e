// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Where the sparse way of scoring wanted pixels crosses the dense one, on 640 × 480 masks: single
// pixels spread evenly (one in 25 … 400), and discs of 10 to 100 % of the picture. The counter
// "costs" is what the scorer believes the ratio sparse : dense to be.

#include <cmath>
#include <cstddef>
#include <new>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/micro_benchmarks/random_picture.h"
#include "lib/core/rng.h"
#include "lib/features/pixel_scorer.h"

namespace handcraft::experiments {
namespace {

using features::ScoringWay;
using Bytes = std::vector<std::uint8_t>;

Bytes Scattered(int width, int height, int one_in) {
  Rng rng = Rng::Stream(1, "scattered");
  Bytes wanted(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::uint8_t& byte : wanted) byte = rng.UniformInt(one_in) == 0 ? 1 : 0;
  return wanted;
}

Bytes Disc(int width, int height, int percent) {
  Bytes wanted;
  wanted.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const double scale = std::hypot(0.5 * width, 0.5 * height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      wanted.push_back(std::hypot(u - 0.5 * width, v - 0.5 * height) <= 0.01 * percent * scale);
    }
  }
  return wanted;
}

void Score(benchmark::State& state,
           const std::string& spec_text,
           ScoringWay way,
           const Bytes& wanted) {
  const Image image = RandomPicture(3);
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  const features::PixelScorer scorer(spec, std::vector<float>(spec.NumFeatures(), 0.01F), 0.1);
  const std::size_t size = scorer.WorkspaceBytes(image.width(), image.height());
  auto* const workspace = static_cast<std::byte*>(::operator new (size, std::align_val_t{64}));
  FloatImage probabilities(image.width(), image.height());
  const features::RawImage raw{image.Row(0),
                               image.width(),
                               image.height(),
                               std::ptrdiff_t{3} * image.width(),
                               features::PixelFormat::kBgr8};
  const features::PixelMask mask{wanted.data(), image.width()};
  for (auto iteration : state) {
    benchmark::DoNotOptimize(scorer.CheaperWay(image.width(), image.height(), mask));
    scorer.ScoreMask(raw, mask, way, {workspace, size}, probabilities.Row(0), image.width());
    benchmark::ClobberMemory();
  }
  ::operator delete (workspace, std::align_val_t{64});
  state.counters["sparse_is_chosen"] =
      scorer.CheaperWay(image.width(), image.height(), mask) == ScoringWay::kSparse ? 1 : 0;
}

void Register(const std::string& spec, const std::string& name, const Bytes& wanted) {
  for (const ScoringWay way : {ScoringWay::kDense, ScoringWay::kSparse}) {
    std::string title = "Region/";
    title.append(spec).append("/").append(name);
    title.append(way == ScoringWay::kDense ? "/dense" : "/sparse");
    benchmark::RegisterBenchmark(title.c_str(), Score, spec, way, wanted)
        ->Unit(benchmark::kMillisecond);
  }
}

const bool kRegistered = [] {
  for (const char* spec : {"all500", "window180", "edges54", "window180,energy=log"}) {
    for (const int one_in : {400, 200, 100, 50, 25}) {
      Register(spec, "one_in_" + std::to_string(one_in), Scattered(640, 480, one_in));
    }
    for (const int percent : {10, 40, 80, 100}) {
      Register(spec, "disc_" + std::to_string(percent), Disc(640, 480, percent));
    }
  }
  return true;
}();

}  // namespace
}  // namespace handcraft::experiments
