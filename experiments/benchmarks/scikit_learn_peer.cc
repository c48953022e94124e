// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/scikit_learn_peer.h"

#include <stdio.h>

#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/formats/npy.h"
#include "experiments/benchmarks/newton_cholesky_script.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// What the command prints; nothing when it fails.
std::optional<std::string> OutputOf(const std::string& command) {
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string output;
  char buffer[256];
  while (::fgets(buffer, sizeof buffer, pipe) != nullptr) output += buffer;
  if (::pclose(pipe) != 0) return std::nullopt;
  return output;
}

}  // namespace

std::optional<ScikitLearnFit> FitWithScikitLearn(std::span<const float> features,
                                                 std::span<const std::uint8_t> labels,
                                                 const std::filesystem::path& scratch) {
  const std::filesystem::path script = scratch / "newton_cholesky.py";
  const std::filesystem::path features_file = scratch / "features.npy";
  const std::filesystem::path labels_file = scratch / "labels.npy";
  WriteFileAtomically(script, std::string_view(kNewtonCholeskyScript));
  datasets::WriteNpy(
      features_file, features.data(), labels.size(), features.size() / labels.size());
  const std::vector<float> labels_as_float(labels.begin(), labels.end());
  datasets::WriteNpy(labels_file, labels_as_float.data(), labels.size(), 1);

  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const std::optional<std::string> output = OutputOf(
        "OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=1 " + std::string(python) + " " +
        Quoted(script.string()) + " " + Quoted(features_file.string()) + " " +
        Quoted(labels_file.string()) + " 2>/dev/null");
    if (!output) continue;
    const auto json = nlohmann::json::parse(*output);
    return ScikitLearnFit{.seconds = json.at("seconds"),
                          .processor_seconds = json.at("processor_seconds"),
                          .log_loss = json.at("log_loss"),
                          .iterations = json.at("iterations"),
                          .version = json.at("version")};
  }
  return std::nullopt;
}

}  // namespace handcraft::experiments
