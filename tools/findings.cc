// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/findings.h"

#include <nlohmann/json.hpp>

#include "lib/core/error.h"

namespace handcraft::tools {

std::string ToText(const datasets::Fault& finding, const std::string& kind) {
  return Error({.path = finding.path,
                .line = finding.line,
                .reason = kind + finding.reason,
                .remedy = finding.remedy})
      .what();
}

nlohmann::ordered_json ToJson(const std::vector<datasets::Fault>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const datasets::Fault& finding : findings) {
    nlohmann::ordered_json& entry = list.emplace_back();
    entry["path"] = finding.path;
    if (finding.line) entry["line"] = *finding.line;
    entry["reason"] = finding.reason;
    if (!finding.remedy.empty()) entry["remedy"] = finding.remedy;
  }
  return list;
}

}  // namespace handcraft::tools
