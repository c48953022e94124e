// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string_view>

#include "lib/runtime/model_error.h"

namespace handcraft::runtime {

/// Whether this library understands a file of format `version` ("MAJOR.MINOR", the value of
/// hc.format; empty: there is none) that asks for `needed` (hc.requires: names of features the
/// reader must know, separated by spaces). docs/model_format.md § 3. Errors: HC_ERROR_FORMAT when
/// the version is missing or no version, HC_ERROR_VERSION naming both sides and what to do.
[[nodiscard]] std::optional<ModelError> CheckFormatVersion(std::string_view version,
                                                           std::string_view needed) noexcept;

}  // namespace handcraft::runtime
