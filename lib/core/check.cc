// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/check.h"

#include <stdexcept>

namespace handcraft::internal {

void FailCheck(const char* file,
               int line,
               const char* condition,
               const char* names,
               const std::string& values) {
  std::string text =
      std::string(file) + ":" + std::to_string(line) + ": check failed: " + condition;
  if (!values.empty()) text += " [" + std::string(names) + " = " + values + "]";
  throw std::logic_error(text);
}

}  // namespace handcraft::internal
