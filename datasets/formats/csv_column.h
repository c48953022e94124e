// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace handcraft::datasets {

/// Writes new values into a column of a CSV file whose first line names its columns, a value a row
/// in the file's order, atomically. Every other field and their order stay; lines end with LF
/// afterwards, and only what must be quoted is. Throws Error naming the file when it cannot be read
/// or written, has no such column or not as many rows as there are values.
void RewriteCsvColumn(const std::filesystem::path& path,
                      std::string_view column,
                      std::span<const std::string> values);

}  // namespace handcraft::datasets
