// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "experiments/benchmarks/benchmark.h"
#include "lib/core/check.h"
#include "lib/core/rng.h"
#include "lib/model_io/linear_models.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {
namespace {

model_io::LinearModel MakeModel(std::size_t num_features) {
  Rng rng = Rng::Stream(1, "load_benchmark");
  model_io::LinearModel model;
  for (std::size_t i = 0; i < num_features; ++i) {
    model.weights.push_back(0.02 * rng.Normal());
    model.feature_mean.push_back(rng.Uniform());
    model.feature_scale.push_back(0.5 + rng.Uniform());
  }
  return model;
}

// The same numbers as OpenCV's own models are kept: YAML text.
std::string ToOpenCvYaml(const model_io::LinearModel& model) {
  cv::FileStorage storage(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << "weights" << model.weights << "mean" << model.feature_mean << "scale"
          << model.feature_scale;
  return storage.releaseAndGetString();
}

}  // namespace

BenchmarkResult BenchmarkLoadModel(const BenchmarkOptions& options) {
  const features::FeatureSpec spec = features::ParseFeatureSpec("all500");
  const model_io::LinearModel model = MakeModel(500);
  model_io::Provenance provenance;
  provenance.name = "load benchmark";
  provenance.task = "grasp_point";
  const std::vector<std::uint8_t> bytes =
      model_io::Serialise(model_io::MakeGraspPointModel(spec, model, provenance));
  const std::string yaml = ToOpenCvYaml(model);

  BenchmarkResult result;
  result.dissertation_ms = std::numeric_limits<double>::quiet_NaN();
  result.peer = "OpenCV FileStorage reads the same numbers from YAML, unchecked";
  result.ours_ms = MedianMs(10 * options.repetitions, [&] {
    hc_model* loaded = nullptr;
    hc_error error{};
    const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &loaded, &error);
    HC_CHECK(status == HC_OK, error.message);
    hc_model_free(loaded);
  });
  result.peer_ms = MedianMs(10 * options.repetitions, [&] {
    cv::FileStorage storage(yaml, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    std::vector<double> weights;
    storage["weights"] >> weights;
    HC_CHECK(weights.size() == 500, weights.size());
  });
  result.ratio = result.peer_ms / result.ours_ms;
  result.details = {{"model_bytes", static_cast<double>(bytes.size())},
                    {"yaml_bytes", static_cast<double>(yaml.size())}};
  return result;
}

}  // namespace handcraft::experiments
