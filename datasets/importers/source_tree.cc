// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/source_tree.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <system_error>

#include "lib/core/error.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void RefuseDanglingLink(const fs::path& path) {
  std::error_code ignored;
  throw Error({.path = path.string(),
               .reason = "is a symbolic link to " + fs::read_symlink(path, ignored).string() +
                         ", where nothing is",
               .remedy = "put the file there, or remove the link"});
}

// Neither a file nor a folder, where one of them is due.
[[noreturn]] void RefuseStrange(const fs::path& path, const char* due, const char* remedy) {
  std::error_code error;
  static_cast<void>(fs::status(path, error));
  if (error) {
    throw Error({.path = path.string(), .reason = "cannot be looked at: " + error.message()});
  }
  throw Error({.path = path.string(),
               .reason = std::string("is a pipe or a device; ") + due + " is due",
               .remedy = remedy});
}

// What stands in a tree but cannot be listed; links whose names begin with a dot are editors'
// locks.
void RefuseLinkThatHidesFiles(const fs::path& path, bool would_be_entered) {
  std::error_code ignored;
  if (!fs::is_symlink(path, ignored) || path.filename().string().starts_with('.')) return;
  const PathKind kind = KindOf(path);
  if (kind == PathKind::kBrokenLink) RefuseDanglingLink(path);
  if (kind == PathKind::kFolder && would_be_entered) {
    throw Error({.path = path.string(),
                 .reason = "is a link to a folder, which is not followed",
                 .remedy = "give the folder itself, or copy it to here"});
  }
}

}  // namespace

void RequireFolder(const fs::path& path) {
  const PathKind kind = KindOf(path);
  if (kind == PathKind::kFile) {
    throw Error({.path = path.string(),
                 .reason = "is a file; a folder is due",
                 .remedy = "give the folder that it lies in"});
  }
  if (kind == PathKind::kOther) RefuseStrange(path, "a folder", "give the folder of the data");
}

void RequireFile(const fs::path& path) {
  const PathKind kind = KindOf(path);
  if (kind == PathKind::kBrokenLink) RefuseDanglingLink(path);
  if (kind == PathKind::kOther) RefuseStrange(path, "a file", "save what it gives to a file");
  if (kind == PathKind::kFolder) {
    throw Error({.path = path.string(),
                 .reason = "is a folder; a file is due",
                 .remedy = "give the folder another name, or remove it"});
  }
  std::error_code ignored;
  if (kind == PathKind::kFile && fs::file_size(path, ignored) == 0) {
    throw Error({.path = path.string(),
                 .reason = "the file is empty",
                 .remedy = "copy it again from its source, or remove it"});
  }
}

bool HasFile(const fs::path& path) {
  RequireFile(path);
  return KindOf(path) != PathKind::kNothing;
}

std::vector<fs::path> ListFiles(const fs::path& folder,
                                int max_depth,
                                const std::function<bool(const fs::path&)>& is_meant) {
  RequireFolder(folder);
  std::error_code error;
  std::error_code ignored;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    if (it.depth() >= max_depth) it.disable_recursion_pending();
    if (it->is_regular_file(ignored)) files.push_back(it->path());
    RefuseLinkThatHidesFiles(it->path(), it.depth() < max_depth);
    if (is_meant(it->path())) RequireFile(it->path());
  }
  if (error) {
    throw Error({.path = folder.string(),
                 .reason = "cannot read the folder: " + error.message(),
                 .remedy = "check the path"});
  }
  std::sort(files.begin(), files.end());
  return files;
}

bool IsNamedLikeAPicture(const fs::path& path) {
  static constexpr std::array<std::string_view, 6> kExtensions = {
      ".png", ".jpg", ".jpeg", ".bmp", ".ppm", ".pgm"};
  std::string extension = path.extension().string();
  for (char& letter : extension) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

std::optional<fs::path> FindNamedFile(const fs::path& folder,
                                      std::string name,
                                      const fs::path& origin) {
  const auto fail = [&](const std::string& fault, const std::string& remedy) {
    throw Error({.path = origin.string(),
                 .reason = "the file name '" + name + "' " + fault,
                 .remedy = remedy});
  };
  std::string slashed = name;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path path(slashed);
  const bool has_drive = slashed.size() > 1 && slashed[1] == ':';
  const std::size_t zero = name.find('\0');
  if (zero != std::string::npos) name.replace(zero, name.size(), "(zero byte)");
  if (path.empty() || zero != std::string::npos) fail("is not one", "correct it");
  if (path.is_absolute() || has_drive || std::find(path.begin(), path.end(), "..") != path.end()) {
    fail("leads out of " + folder.string(), "keep the pictures below that folder");
  }
  if (!HasFile(folder / path)) return std::nullopt;
  return path.lexically_normal();
}

std::string ClassOfPath(const fs::path& relative) {
  return relative.has_parent_path() ? relative.begin()->string() : "object";
}

}  // namespace handcraft::datasets
