// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/structured_text/toml_file.h"

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft {

toml::table ReadTomlFile(const std::filesystem::path& path) {
  return ParseToml(ReadTextFile(path), path.string());
}

toml::table ParseToml(std::string_view text, const std::string& name) {
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw Error({.path = name,
                 .line = error.source().begin.line,
                 .reason = "not TOML: " + std::string(error.description()),
                 .remedy = "see https://toml.io"});
  }
}

}  // namespace handcraft
