// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <CLI/App.hpp>

#include "datasets/synthetic/camera.h"

/// Options that mean the same for every kind of made-up set.
namespace handcraft::tools {

/// `--out DIR`, which must be given.
void AddSetFolder(CLI::App& command, std::string& out);

/// `--camera FILE`: empty when not given.
void AddCameraFile(CLI::App& command, std::string& path);

/// Takes intrinsics and baseline over from that file; leaves a baseline that it does not name, and
/// everything when the path is empty. Throws Error as synthetic::ReadCameraFile does.
void ApplyCameraFile(const std::string& path, synthetic::PinholeCamera& camera, float& baseline_m);

}  // namespace handcraft::tools
