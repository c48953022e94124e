// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>

#include "lib/runtime/model_header.h"
#include "lib/runtime/result.h"

namespace handcraft::runtime {

/// Reads and verifies the bytes of a model file: everything docs/model_format.md § 2 and § 3 ask
/// for. What the tensors mean (§ 5, § 6) is not looked at. The result holds views into `bytes`.
///
/// Errors: HC_ERROR_TRUNCATED, _FORMAT, _CHECKSUM, _VERSION, _MEMORY. A file that is long enough
/// but whose checksum is wrong is reported as damaged, whatever else the damage broke. Never reads
/// outside `bytes`, never recurses; O(size) time; allocates a few times the header's size at most.
[[nodiscard]] Result<ParsedModel> ParseModel(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace handcraft::runtime
