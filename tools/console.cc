// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/console.h"

#include <ostream>

#include <nlohmann/json.hpp>

#include "lib/core/utf8.h"

namespace handcraft::tools {

void Console::Warn(std::string_view text) const {
  err << "handcraft: warning: " << OnOneLine(text) << '\n';
}

void Console::Print(const nlohmann::ordered_json& json) const {
  out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

}  // namespace handcraft::tools
