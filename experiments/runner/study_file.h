// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "experiments/runner/study.h"
#include "experiments/runner/study_entries.h"

namespace handcraft::experiments {

/// Reads a study file (TOML; docs/studies.md has its keys). Every key must be known, every setting
/// fit its rule, names be told apart, and something be left to test on. Throws Error with path and
/// line.
[[nodiscard]] Study ReadStudy(const std::filesystem::path& file, StudySize size);

/// The same from the file's text; `source` stands for its path in messages.
[[nodiscard]] Study ParseStudy(std::string_view text, const std::string& source, StudySize size);

}  // namespace handcraft::experiments
