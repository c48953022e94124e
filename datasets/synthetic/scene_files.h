// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/formats/organised_cloud.h"
#include "datasets/synthetic/camera.h"
#include "datasets/synthetic/scene.h"
#include "lib/core/image.h"
#include "lib/core/progress.h"

/// The files of made-up sets, whatever their kind (docs/synthetic_data.md).
namespace handcraft::synthetic {

/// Under which terms made-up pictures may be passed on.
inline constexpr std::string_view kSyntheticLicence = "CC0-1.0";

/// What is written of one scene. What is empty is left out.
struct SceneFiles {
  Image image = {};                     ///< images/NAME.png
  Image right_image = {};               ///< images/NAME_right.png
  Image mask = {};                      ///< masks/NAME.png
  Image object_mask = {};               ///< object_masks/NAME.png
  datasets::OrganisedCloud cloud = {};  ///< clouds/NAME.pcd
  FloatImage depth = {};   ///< depth/NAME.png: 16 bits, millimetres; 0: nothing there [m]
  std::string scene = {};  ///< scenes/NAME.toml, written last
};

/// FOLDER/NAME and an ending, relative to the set's folder.
[[nodiscard]] std::string ScenePath(std::string_view folder,
                                    std::string_view name,
                                    std::string_view ending);

/// Whether every file of the scene is there as WriteSceneFiles left it: reads them all. Throws
/// Error when one that is there cannot be read.
[[nodiscard]] bool IsWhole(const std::filesystem::path& root, std::string_view name);

/// Writes the scene's files into the folders of the set, the TOML last. It ends with a table
/// [files], whose `sha256` is that of a line "path \0 SHA-256 of the file \n" for each of the
/// others, in the order of SceneFiles, and of the TOML before the table. Throws Error when it
/// cannot write.
void WriteSceneFiles(const std::filesystem::path& root,
                     std::string_view name,
                     const SceneFiles& files);

/// The same with what `make` returns, unless the scene is whole. Returns whether it wrote.
[[nodiscard]] bool WriteUnlessWhole(const std::filesystem::path& root,
                                    std::string_view name,
                                    const std::function<SceneFiles()>& make);

/// Calls `write`, which tells whether it wrote a scene, for each number on several threads, as
/// ParallelForReporting does. Returns how many were written.
[[nodiscard]] std::size_t CountWritten(std::size_t num_scenes,
                                       int num_threads,
                                       const Progress& progress,
                                       std::string_view stage,
                                       const std::function<bool(std::size_t)>& write);

/// The pose as two lines of TOML: KEY_position_m = [x, y, z], KEY_quaternion_xyzw = [x, y, z, w].
[[nodiscard]] std::string PoseToToml(std::string_view key, const Eigen::Isometry3f& pose);

/// The tables [camera], with the baseline where there is a second one, and [depth] of dataset.toml.
[[nodiscard]] std::string CameraToToml(const PinholeCamera& camera,
                                       std::optional<float> baseline_m);

/// The text of a scene's TOML: class, instance, poses of the camera and of each target.
[[nodiscard]] std::string SceneToToml(std::string_view object_class,
                                      int instance,
                                      const Scene& scene);

}  // namespace handcraft::synthetic
