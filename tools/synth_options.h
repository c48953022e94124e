// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <CLI/App.hpp>

#include "datasets/synthetic/camera.h"
#include "datasets/synthetic/measured_view.h"
#include "datasets/synthetic/set_folder.h"

/// Options that mean the same for every kind of made-up set.
namespace handcraft::tools {

/// `--out DIR`, which must be given.
void AddSetFolder(CLI::App& command, std::string& out);

/// `--family`: taught, untaught or regrasp, the families of single objects.
void AddObjectFamily(CLI::App& command, std::string& family);

/// `--sensor`: what measures the clouds, by the names of synthetic::NameOf.
void AddCloudSensor(CLI::App& command, std::string& sensor);

/// The sensor of that name, which AddCloudSensor has let pass.
[[nodiscard]] synthetic::CloudSensor SensorNamed(std::string_view name);

/// `--camera FILE`: empty when not given.
void AddCameraFile(CLI::App& command, std::string& path);

/// Takes intrinsics and baseline over from that file; leaves a baseline that it does not name, and
/// everything when the path is empty. Throws Error as synthetic::ReadCameraFile does.
void ApplyCameraFile(const std::string& path, synthetic::PinholeCamera& camera, float& baseline_m);

/// What a command says at its end of the set in `folder`, which has so many pictures and `contents`
/// in all ("480 poses"): whether all of it was written, a part, or nothing.
[[nodiscard]] std::string TellWritten(const synthetic::Written& written,
                                      std::size_t num_pictures,
                                      const std::string& contents,
                                      const std::string& folder);

}  // namespace handcraft::tools
