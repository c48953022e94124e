// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The C interface as a robot calls it: load, score, best points.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "experiments/micro_benchmarks/random_picture.h"
#include "lib/core/check.h"
#include "lib/core/rng.h"
#include "lib/model_io/linear_models.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {
namespace {

std::vector<std::uint8_t> ModelBytes(const std::string& spec_text) {
  const features::FeatureSpec spec = features::ParseFeatureSpec(spec_text);
  const std::size_t num_features = spec.NumFeatures();
  model_io::LinearModel model;
  model.weights.assign(num_features, 1e-3);
  model.feature_mean.assign(num_features, 0.5);
  model.feature_scale.assign(num_features, 2.0);
  model_io::Provenance provenance;
  provenance.name = "runtime benchmark";
  provenance.task = "grasp_point";
  return model_io::Serialise(model_io::MakeGraspPointModel(spec, model, provenance));
}

using ModelPointer = std::unique_ptr<hc_model, decltype(&hc_model_free)>;

ModelPointer Load(const std::vector<std::uint8_t>& bytes) {
  hc_model* model = nullptr;
  hc_error error{};
  const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &model, &error);
  HC_CHECK(status == HC_OK, error.message);
  return {model, &hc_model_free};
}

void LoadModel(benchmark::State& state, const std::string& spec_text) {
  const std::vector<std::uint8_t> bytes = ModelBytes(spec_text);
  for (auto iteration : state) benchmark::DoNotOptimize(Load(bytes).get());
  state.counters["model_bytes"] = static_cast<double>(bytes.size());
}
BENCHMARK_CAPTURE(LoadModel, all500, "all500")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(LoadModel, edges54, "edges54")->Unit(benchmark::kMicrosecond);

void ScoreImage(benchmark::State& state, const std::string& spec_text) {
  const ModelPointer model = Load(ModelBytes(spec_text));
  const Image picture = RandomPicture(3);
  hc_workspace* workspace = nullptr;
  HC_CHECK(hc_workspace_create(model.get(), 640, 480, &workspace) == HC_OK);
  const hc_image image{.data = picture.Row(0),
                       .width = 640,
                       .height = 480,
                       .stride_bytes = std::int64_t{3} * 640,
                       .format = HC_BGR8};
  std::vector<float> probabilities(std::size_t{640} * 480);
  for (auto iteration : state) {
    HC_CHECK(hc_score_image(model.get(), workspace, &image, probabilities.data(), 640) == HC_OK);
  }
  hc_workspace_free(workspace);
}
BENCHMARK_CAPTURE(ScoreImage, all500_log, "all500,energy=log")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ScoreImage, edges54_log, "edges54,energy=log")->Unit(benchmark::kMillisecond);

// Noise is the worst case: every neighbourhood has a peak of its own.
void TopK(benchmark::State& state) {
  Rng rng = Rng::Stream(1, "micro_benchmarks.probabilities");
  std::vector<float> probabilities(std::size_t{640} * 480);
  for (float& probability : probabilities) probability = static_cast<float>(rng.Uniform());
  std::vector<hc_point> points(static_cast<std::size_t>(state.range(0)));
  for (auto iteration : state) {
    std::size_t count = points.size();
    HC_CHECK(hc_top_k(probabilities.data(), 640, 480, 640, 0.5F, 8, points.data(), &count) ==
             HC_OK);
  }
}
BENCHMARK(TopK)->Arg(1)->Arg(15)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace handcraft::experiments
