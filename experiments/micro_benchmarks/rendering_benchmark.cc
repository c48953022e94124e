// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// A made-up picture: its rendering with soft shadows, labels and depth, and its development. Each
// case goes round the classes, so run it long enough for several rounds.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "datasets/synthetic/renderer.h"
#include "datasets/synthetic/sensor.h"

namespace handcraft::experiments {
namespace {

using synthetic::Scene;

// Two scenes of each trained class.
std::vector<Scene> DrawScenes() {
  std::vector<Scene> scenes;
  for (std::uint64_t round = 0; round < 2; ++round) {
    for (const synthetic::ObjectClass& kind : synthetic::ClassesOf(synthetic::Family::kTrained)) {
      Rng rng = Rng::Stream(1, kind.name, round);
      std::vector<synthetic::Object> targets;
      targets.reserve(static_cast<std::size_t>(kind.num_objects));
      for (int i = 0; i < kind.num_objects; ++i) targets.push_back(kind.draw(rng));
      scenes.push_back(synthetic::DrawScene(targets, rng));
    }
  }
  return scenes;
}

void MakeView(const Scene& scene, const synthetic::PinholeCamera& camera) {
  Rng noise = Rng::Stream(1, "noise");
  const synthetic::View view = synthetic::Render(scene, camera);
  benchmark::DoNotOptimize(synthetic::Develop(view.light, scene.sensor, noise));
}

void MakeOneView(benchmark::State& state) {
  const std::vector<Scene> scenes = DrawScenes();
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Scene& scene = scenes[i++ % scenes.size()];
    MakeView(scene, scene.camera);
  }
}
BENCHMARK(MakeOneView)->Unit(benchmark::kMillisecond);

void MakeStereoPair(benchmark::State& state) {
  const std::vector<Scene> scenes = DrawScenes();
  std::size_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    const Scene& scene = scenes[i++ % scenes.size()];
    MakeView(scene, scene.camera);
    MakeView(scene, synthetic::RightOf(scene.camera, 0.12F));
  }
}
BENCHMARK(MakeStereoPair)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handcraft::experiments
