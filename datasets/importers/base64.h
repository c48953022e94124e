// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace handcraft::datasets {

/// The bytes that base64 text stands for (RFC 4648, section 4: the alphabet with + and /, padded by
/// =); line ends are skipped. Nothing when the text is anything else.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> DecodeBase64(std::string_view text);

}  // namespace handcraft::datasets
