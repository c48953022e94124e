// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace handcraft::tools {

/// The folder a command writes several files into: all of them, or none. Unless Keep is called,
/// the files and folders made through it are removed again with the object.
class OutputFolder {
 public:
  /// Makes the folder, and those above it, where they are missing. Throws Error.
  explicit OutputFolder(const std::filesystem::path& folder);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write the file of this name. Throws Error(kUsage) when it was asked for before: two
  /// inputs would write the same file.
  [[nodiscard]] std::filesystem::path Claim(const std::string& name);

  void Keep() noexcept { keep_ = true; }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_folders_;  ///< outermost first
  std::vector<std::filesystem::path> files_;
  bool keep_ = false;
};

}  // namespace handcraft::tools
