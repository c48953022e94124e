// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/json_text.h"

#include <charconv>

#include "lib/core/fields.h"

namespace handcraft::experiments {

void AddEstimate(const std::string& key, const Estimate& estimate, nlohmann::ordered_json& json) {
  json[key] = estimate.value;
  json[key + "_interval"] = {estimate.low, estimate.high};
}

nlohmann::ordered_json ConfusionJson(const ConfusionMatrix& matrix) {
  return {{"true_positive", matrix.true_positive},
          {"false_positive", matrix.false_positive},
          {"true_negative", matrix.true_negative},
          {"false_negative", matrix.false_negative}};
}

nlohmann::ordered_json RocJson(std::span<const RocPoint> curve) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const RocPoint& point : curve) {
    json.push_back({point.false_positive_rate, point.true_positive_rate});
  }
  return json;
}

double ShortestDouble(float value) {
  const std::string text = NumberToText(value);
  double result = value;  // infinities and NaN keep their value
  std::from_chars(text.data(), text.data() + text.size(), result);
  return result;
}

std::string JsonText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace handcraft::experiments
