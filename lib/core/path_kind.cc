// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/path_kind.h"

#include <sys/stat.h>

#include <cerrno>

namespace handcraft {

PathKind KindOf(const std::filesystem::path& path) noexcept {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    if (S_ISREG(status.st_mode)) return PathKind::kFile;
    return S_ISDIR(status.st_mode) ? PathKind::kFolder : PathKind::kOther;
  }
  if (::lstat(path.c_str(), &status) == 0) {
    return S_ISLNK(status.st_mode) ? PathKind::kBrokenLink : PathKind::kOther;
  }
  const bool leads_nowhere = errno == ENOENT || errno == ENOTDIR || errno == ELOOP;
  return leads_nowhere ? PathKind::kNothing : PathKind::kOther;
}

bool Exists(const std::filesystem::path& path) noexcept {
  const PathKind kind = KindOf(path);
  return kind != PathKind::kNothing && kind != PathKind::kBrokenLink;
}

}  // namespace handcraft
