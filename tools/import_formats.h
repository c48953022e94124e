// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include <CLI/App.hpp>

#include "datasets/importers/image_set_import.h"

namespace handcraft::tools {

/// Lists what a source holds, with the options as they were given.
using SourceLister = std::function<datasets::SourceSet(const std::filesystem::path& source)>;

/// What is made of a source.
enum class SetKind { kLabelledImages, kViews };

/// A format that `handcraft data import` reads: the options of its own; all others it shares.
struct ImportFormat {
  const char* name;         ///< of the subcommand
  const char* description;  ///< in the list of formats
  const char* source;       ///< what SRC is
  const char* example;      ///< what follows `handcraft data import` in its --help
  SourceLister (*add_options)(CLI::App& command);
  SetKind makes = SetKind::kLabelledImages;
};

/// All of them, in the order of --help.
[[nodiscard]] std::span<const ImportFormat> ImportFormats();

}  // namespace handcraft::tools
