// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace handcraft {

/// Reads a TOML file. Throws Error naming path, line and fault when it cannot be read or is no
/// TOML. Source: TOML v1.0.0.
[[nodiscard]] toml::table ReadTomlFile(const std::filesystem::path& path);

/// The same of a text; messages name it `name`.
[[nodiscard]] toml::table ParseToml(std::string_view text, const std::string& name);

}  // namespace handcraft
