// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/error.h"

#include <utility>

#include "lib/core/utf8.h"

namespace handcraft {
namespace {

std::string Describe(const Error::Details& details) {
  std::string text = details.path;
  if (details.line) text += ":" + std::to_string(*details.line);
  if (details.byte) text += " at byte " + std::to_string(*details.byte);
  if (!text.empty()) text += ": ";
  text += details.reason;
  if (!details.remedy.empty()) text += " (" + details.remedy + ")";
  return OnOneLine(text);  // a name may hold a line end
}

}  // namespace

Error::Error(Details details)
    : std::runtime_error(Describe(details)), details_(std::move(details)) {}

int ExitCode(Error::Kind kind) noexcept {
  switch (kind) {
    case Error::Kind::kUsage:
      return 2;
    case Error::Kind::kBadInput:
      return 3;
    case Error::Kind::kNoResult:
      return 4;
  }
  return 1;
}

}  // namespace handcraft
