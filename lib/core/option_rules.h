// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "lib/core/error.h"
#include "lib/core/fields.h"

namespace handcraft {

/// Throws Error(kUsage) "Struct.field is value; it must be rule" unless `holds`.
template <class T>
void RequireOption(bool holds, const std::string& field, T value, const std::string& rule) {
  if (holds) return;
  throw Error({.kind = Error::Kind::kUsage,
               .reason = field + " is " + NumberToText(value) + "; it must be " + rule});
}

}  // namespace handcraft
