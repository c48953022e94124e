// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "lib/perception/table_removal.h"
#include "lib/runtime/handcraft_runtime.h"
#include "tools/console.h"

namespace handcraft::tools {

/// Throws Error(kUsage): the option was given, and the model is not of object classes.
[[noreturn]] void RefuseCloudOption(const std::string& option);

/// What `handcraft evaluate` is told when the model is of object classes.
struct EvaluateCloudsOptions {
  std::string model;
  std::string data;                    ///< view set
  std::string split;                   ///< empty: all views
  std::vector<std::string> counts_as;  ///< CLASS=CLASS OF THE MODEL
  std::string json;
};

/// Prints confusion matrix and accuracy, or JSON. Throws Error(kUsage) for a --counts-as without
/// '=', and as experiments::EvaluateClouds does.
void EvaluateClouds(const hc_model* model,
                    const EvaluateCloudsOptions& options,
                    const Console& console);

/// What `handcraft predict` is told when the model is of object classes.
struct PredictCloudsOptions {
  std::string model;
  std::vector<std::string> clouds;  ///< PCD files
  std::string object_mask;  ///< picture of the clouds' size; empty: what stands on the table
  perception::TableRemovalOptions table = {};
};

/// The class of the object in each cloud: [{"cloud", "class", "nearest_class", "margin",
/// "rejection_threshold", "decision_values"}, …]; a rejected one has the class null, a model that
/// rejects nothing the threshold null. Throws Error(kNoResult) when too little of an object was
/// measured, Error(kBadInput) when a file is no organised cloud.
[[nodiscard]] nlohmann::ordered_json PredictClouds(const hc_model* model,
                                                   const PredictCloudsOptions& options);

/// Such predictions as a table for people.
[[nodiscard]] std::string CloudTable(const nlohmann::ordered_json& predictions);

}  // namespace handcraft::tools
