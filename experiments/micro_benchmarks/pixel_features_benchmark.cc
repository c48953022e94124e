// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// What training does with a picture: filter it once, then gather vectors at single pixels.

#include <cstddef>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/micro_benchmarks/random_picture.h"
#include "lib/core/rng.h"
#include "lib/features/pixel_features.h"

namespace handcraft::experiments {
namespace {

features::RawImage RawView(const Image& image) {
  return {image.Row(0),
          image.width(),
          image.height(),
          std::ptrdiff_t{3} * image.width(),
          features::PixelFormat::kBgr8};
}

void FilterPicture(benchmark::State& state, const std::string& spec_text) {
  const Image image = RandomPicture(3);
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  for (auto iteration : state) {
    const features::PixelFeatures planes(RawView(image), spec);
    benchmark::DoNotOptimize(planes.EnergyPlane(0));
  }
}
BENCHMARK_CAPTURE(FilterPicture, all500, "all500")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(FilterPicture, all500_log, "all500,energy=log")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(FilterPicture, edges54, "edges54")->Unit(benchmark::kMillisecond);

void GatherVector(benchmark::State& state, const std::string& spec_text) {
  const Image image = RandomPicture(3);
  const features::PixelFeatures planes(RawView(image), features::ParseFeatureSpec(spec_text));
  std::vector<float> vector(planes.spec().NumFeatures());
  Rng rng = Rng::Stream(1, "micro_benchmarks.pixels");
  for (auto iteration : state) {
    const int u = static_cast<int>(rng.UniformInt(640));
    const int v = static_cast<int>(rng.UniformInt(480));
    planes.Gather(u, v, vector);
    benchmark::DoNotOptimize(vector.data());
  }
}
BENCHMARK_CAPTURE(GatherVector, all500, "all500");
BENCHMARK_CAPTURE(GatherVector, edges54, "edges54");

}  // namespace
}  // namespace handcraft::experiments
