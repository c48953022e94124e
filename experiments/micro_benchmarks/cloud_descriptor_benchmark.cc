// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// What describing an object's cloud costs: grid of 50 × 50 cells over 120 × 120 px.

#include <cstddef>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>

#include "lib/core/rng.h"
#include "lib/features/cloud_descriptor.h"

namespace handcraft::features {
namespace {

constexpr int kSide_px = 120;
constexpr int kHalf_px = kSide_px / 2;

// A bent surface 0.12 m wide, 0.6 m away, with noise; a twentieth is not measured.
std::vector<float> BentSurface() {
  Rng rng = Rng::Stream(1, "micro_benchmarks.cloud_descriptor");
  std::vector<float> points;
  for (int v = 0; v < kSide_px; ++v) {
    for (int u = 0; u < kSide_px; ++u) {
      const double x = 0.001 * (u - kHalf_px);
      const double y = 0.001 * (v - kHalf_px);
      const double z = rng.UniformInt(20) == 0 ? std::numeric_limits<double>::quiet_NaN()
                                               : 0.6 + 4.0 * x * x + 0.001 * rng.Normal();
      for (const double value : {x, y, z}) points.push_back(static_cast<float>(value));
    }
  }
  return points;
}

void Describe(benchmark::State& state, CloudDescriptorType type) {
  const std::vector<float> points = BentSurface();
  const ObjectCloud cloud{
      .points = points.data(), .width = kSide_px, .height = kSide_px, .row_stride = 3 * kSide_px};
  const CloudDescriptor descriptor{.type = type, .frame = CloudFrame::kCamera};
  std::vector<std::byte> workspace(descriptor.WorkspaceBytes());
  std::vector<float> features(descriptor.NumFeatures());
  for (auto _ : state) {
    bool done = descriptor.Compute(cloud, workspace, features);
    benchmark::DoNotOptimize(done);
  }
}
BENCHMARK_CAPTURE(Describe, grid, CloudDescriptorType::kGrid);
BENCHMARK_CAPTURE(Describe, polar, CloudDescriptorType::kPolar);
BENCHMARK_CAPTURE(Describe, vfh, CloudDescriptorType::kViewpointHistogram);
BENCHMARK_CAPTURE(Describe, esf, CloudDescriptorType::kShapeFunctions);

}  // namespace
}  // namespace handcraft::features
