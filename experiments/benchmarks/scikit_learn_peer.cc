// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/scikit_learn_peer.h"

#include <vector>

#include "datasets/formats/npy.h"
#include "experiments/benchmarks/peer_scripts.h"
#include "experiments/benchmarks/python_peer.h"

namespace handcraft::experiments {

std::optional<ScikitLearnFit> FitWithScikitLearn(std::span<const float> features,
                                                 std::span<const std::uint8_t> labels,
                                                 const std::filesystem::path& scratch) {
  const std::filesystem::path features_file = scratch / "features.npy";
  const std::filesystem::path labels_file = scratch / "labels.npy";
  datasets::WriteNpy(
      features_file, features.data(), labels.size(), features.size() / labels.size());
  const std::vector<float> labels_as_float(labels.begin(), labels.end());
  datasets::WriteNpy(labels_file, labels_as_float.data(), labels.size(), 1);
  const auto json = RunPythonPeer(kNewtonCholeskyScript, {features_file, labels_file}, scratch, 1);
  if (!json) return std::nullopt;
  return ScikitLearnFit{.seconds = json->at("seconds"),
                        .processor_seconds = json->at("processor_seconds"),
                        .log_loss = json->at("log_loss"),
                        .iterations = json->at("iterations"),
                        .version = json->at("version")};
}

}  // namespace handcraft::experiments
