// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/output_folder.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "lib/core/error.h"
#include "lib/core/path_kind.h"

namespace handcraft::tools {

OutputFolder::OutputFolder(const std::filesystem::path& folder)
    : folder_(std::filesystem::absolute(folder).lexically_normal()) {
  std::filesystem::path level;
  for (const std::filesystem::path& part : folder_) {
    level /= part;
    std::error_code error;
    if (std::filesystem::create_directory(level, error)) made_folders_.push_back(level);
    if (KindOf(level) != PathKind::kFolder) {
      const std::string why = error ? error.message() : "a file of this name is in the way";
      for (const auto& made : made_folders_) std::filesystem::remove(made, error);
      throw Error({.path = folder.string(), .reason = "cannot create the folder: " + why});
    }
  }
}

OutputFolder::~OutputFolder() {
  if (keep_) return;
  std::error_code ignored;
  for (const auto& file : files_) std::filesystem::remove(file, ignored);
  // Innermost first; a folder somebody else has put a file into stays.
  std::reverse(made_folders_.begin(), made_folders_.end());
  for (const auto& made : made_folders_) std::filesystem::remove(made, ignored);
}

std::filesystem::path OutputFolder::Claim(const std::string& name) {
  std::filesystem::path file = folder_ / name;
  if (std::find(files_.begin(), files_.end(), file) != files_.end()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = file.string(),
                 .reason = "two inputs would write this file",
                 .remedy = "rename one, or call the command twice with two folders"});
  }
  files_.push_back(file);
  return file;
}

}  // namespace handcraft::tools
