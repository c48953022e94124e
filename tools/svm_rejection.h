// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "trainers/svm/rejection.h"

namespace handcraft::tools {

/// What is said of samples that belong to no class.
struct NovelOptions {
  std::string path = {};  ///< of such samples; empty: none
  double max_lost = 1.0;  ///< share of the known samples that may be rejected
};

/// --novel PATH, a `type` of `samples` ("rows"), and --max-lost, which needs it.
void AddNovelOptions(CLI::App& command,
                     const std::string& type,
                     const std::string& samples,
                     NovelOptions& novel);

/// The lowest threshold of each of a few shares of the novel samples that shall be found, those
/// that no threshold finds left out.
[[nodiscard]] std::vector<svm::Rejection> FewOf(const std::vector<svm::Rejection>& trade_off);

/// Threshold, shares on the wrong side, and what others would cost.
void AddJson(const svm::Calibration& calibration, nlohmann::ordered_json& json);
[[nodiscard]] std::string ToText(const svm::Calibration& calibration, const std::string& samples);

/// What the model file says of it.
void AddMetrics(const svm::Calibration& calibration, std::map<std::string, std::string>& metrics);

/// What is said when a class was added to a model that had a threshold, which is gone.
[[nodiscard]] std::string DroppedThresholdText(double threshold);

}  // namespace handcraft::tools
