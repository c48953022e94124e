// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "datasets/formats/fault.h"

namespace handcraft::tools {

/// What was found in a data set, as a line for people: `path:line: reason (remedy)`; `kind` stands
/// before the reason.
[[nodiscard]] std::string ToText(const datasets::Fault& finding, const std::string& kind = "");

/// The same for machines: a list of objects with path and reason, line and remedy where
/// there are any.
[[nodiscard]] nlohmann::ordered_json ToJson(const std::vector<datasets::Fault>& findings);

}  // namespace handcraft::tools
