// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/number_option.h"

#include <string_view>

namespace handcraft::tools {

std::string RuleOf(const Error& refusal) {
  constexpr std::string_view kBeforeTheRule = "must be ";
  const std::string& reason = refusal.details().reason;
  const std::size_t at = reason.find(kBeforeTheRule);
  return at == std::string::npos ? reason : reason.substr(at + kBeforeTheRule.size());
}

CLI::Validator IntegerWithin(int lowest, int highest) {
  return CheckNumber<int>([lowest, highest](int value) -> std::string {
    if (value >= lowest && value <= highest) return "";
    return "from " + NumberToText(lowest) + " to " + NumberToText(highest);
  });
}

}  // namespace handcraft::tools
