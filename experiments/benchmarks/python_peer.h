// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace handcraft::experiments {

/// Runs `script`, the text of a program, in a python3 of its own with the files as arguments, BLAS
/// held to `num_threads`, and returns the JSON that it prints. The program is written to `scratch`.
/// Nothing when it fails or prints anything else: first the python3 on the PATH is tried, then the
/// system's.
[[nodiscard]] std::optional<nlohmann::json> RunPythonPeer(
    std::string_view script,
    const std::vector<std::filesystem::path>& arguments,
    const std::filesystem::path& scratch,
    int num_threads);

}  // namespace handcraft::experiments
