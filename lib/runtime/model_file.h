// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/runtime/result.h"

namespace handcraft::runtime {

/// The whole file as bytes, at most max_bytes of them. Errors: HC_ERROR_FILE with the system's
/// reason and the path (cut to fit), HC_ERROR_FORMAT when the file is larger, HC_ERROR_MEMORY.
[[nodiscard]] Result<std::vector<std::uint8_t>> ReadModelFile(const char* path,
                                                              std::size_t max_bytes) noexcept;

}  // namespace handcraft::runtime
