// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handcraft::datasets {

/// What a made-up set was made with; there before its list is.
inline constexpr std::string_view kMadeUpFileName = "dataset.toml";

/// Passes a folder that holds the list `name`, and a path where nothing is: opening the list will
/// tell. Throws Error that says what else `root` is: a file, a made-up set that was not finished, a
/// set of another kind, or none. `kind` is what the list makes of a folder, as in "a view set".
void RequireList(const std::filesystem::path& root, std::string_view name, const std::string& kind);

}  // namespace handcraft::datasets
