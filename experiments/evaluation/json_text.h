// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "experiments/metrics/binary_metrics.h"

namespace handcraft::experiments {

/// json[key] = value and json[key + "_interval"] = [low, high]; NaN becomes null.
void AddEstimate(const std::string& key, const Estimate& estimate, nlohmann::ordered_json& json);

[[nodiscard]] nlohmann::ordered_json ConfusionJson(const ConfusionMatrix& matrix);

/// [[false positive rate, true positive rate], …]
[[nodiscard]] nlohmann::ordered_json RocJson(std::span<const RocPoint> curve);

/// The double with the fewest digits that reads back as this float: 0.9F → 0.9, not
/// 0.89999998.
[[nodiscard]] double ShortestDouble(float value);

/// Two-space indentation, line feed at the end, NaN as null, bytes that are not UTF-8 replaced by
/// U+FFFD.
[[nodiscard]] std::string JsonText(const nlohmann::ordered_json& json);

}  // namespace handcraft::experiments
