// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/toml_file.h"

#include <string>

#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {

toml::table ReadTomlFile(const std::filesystem::path& path) {
  const std::string text = ReadTextFile(path);
  try {
    return toml::parse(text, path.string());
  } catch (const toml::parse_error& error) {
    throw Error({.path = path.string(),
                 .line = error.source().begin.line,
                 .reason = "not TOML: " + std::string(error.description()),
                 .remedy = "see https://toml.io"});
  }
}

}  // namespace handcraft::datasets
