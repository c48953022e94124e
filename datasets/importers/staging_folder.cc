// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/staging_folder.h"

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "lib/core/error.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& path,
                       const std::string& doing,
                       const std::error_code& error) {
  throw Error({.path = path.string(),
               .reason = "cannot " + doing + ": " + error.message(),
               .remedy = "the folder it is to lie in must exist and be writable"});
}

void CheckIsFree(const fs::path& target) {
  std::error_code error;
  if (!fs::exists(target, error)) return;
  if (fs::is_directory(target, error) && fs::is_empty(target, error) && !error) return;
  throw Error({.kind = Error::Kind::kUsage,
               .path = target.string(),
               .reason = "is there already and is not an empty folder",
               .remedy = "remove it or choose another name"});
}

}  // namespace

StagingFolder::StagingFolder(const fs::path& target) : target_(fs::absolute(target)) {
  CheckIsFree(target);
  target_ = target_.lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();        // "name/" is "name"
  std::string pattern = target_.string() + '.' + std::string(6, 'X');  // mkdtemp fills in
  if (::mkdtemp(pattern.data()) == nullptr) {
    Fail(target, "make the folder", std::error_code(errno, std::generic_category()));
  }
  temporary_ = pattern;
  path_ = temporary_ / target_.filename();
  std::error_code error;
  fs::create_directory(path_, error);
  if (error) {
    ::rmdir(temporary_.c_str());
    Fail(target, "make the folder", error);
  }
}

StagingFolder::~StagingFolder() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
}

void StagingFolder::AddFolder(const fs::path& name) const {
  std::error_code error;
  fs::create_directory(path_ / name, error);
  if (error) Fail(target_ / name, "make the folder", error);
}

void StagingFolder::Remove(const fs::path& name) const {
  std::error_code error;
  fs::remove(path_ / name, error);
  for (fs::path at = name.parent_path(); !at.empty() && !error; at = at.parent_path()) {
    fs::remove(path_ / at, error);  // fails where something is left
  }
}

void StagingFolder::MoveToTarget() {
  std::error_code error;
  fs::rename(path_, target_, error);
  if (error) Fail(target_, "move the finished folder to its place", error);
}

}  // namespace handcraft::datasets
