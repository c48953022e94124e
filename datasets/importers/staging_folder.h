// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>

namespace handcraft::datasets {

/// A folder that is filled beside its final place and appears there whole or not at all: unless
/// MoveToTarget was called, it goes away with the object. Throws Error when the target is a file or
/// a folder that is not empty, or its parent is missing.
class StagingFolder {
 public:
  explicit StagingFolder(const std::filesystem::path& target);
  ~StagingFolder();
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  /// Where to write, until MoveToTarget.
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Makes a folder of this name inside.
  void AddFolder(const std::filesystem::path& name) const;

  /// Removes a file, if it is there, and the folders inside that are empty without it.
  void Remove(const std::filesystem::path& name) const;

  void MoveToTarget();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< private to us; holds path_
  std::filesystem::path path_;
};

}  // namespace handcraft::datasets
