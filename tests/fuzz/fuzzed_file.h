// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace handcraft::testing {

/// Ends the program, as a fuzzer wants it, unless the condition holds.
inline void Require(bool condition) {
  if (!condition) __builtin_trap();
}

/// A file in memory, for readers that take a path, and a folder to put it into under the names
/// that they look for. One of them serves all runs of a fuzz target.
class FuzzedFile {
 public:
  FuzzedFile() : descriptor_(memfd_create("fuzzed", 0)) {
    Require(descriptor_ >= 0);
    std::string name = (std::filesystem::temp_directory_path() / "fuzzed_XXXXXX").string();
    Require(mkdtemp(name.data()) != nullptr);
    folder_ = name;
  }
  ~FuzzedFile() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    close(descriptor_);
  }
  FuzzedFile(const FuzzedFile&) = delete;
  FuzzedFile& operator=(const FuzzedFile&) = delete;

  /// What the file holds from now on.
  void Fill(std::string_view bytes) const {
    Require(ftruncate(descriptor_, 0) == 0);
    Require(pwrite(descriptor_, bytes.data(), bytes.size(), 0) ==
            static_cast<ssize_t>(bytes.size()));
  }

  [[nodiscard]] std::filesystem::path path() const {
    return "/proc/self/fd/" + std::to_string(descriptor_);
  }

  /// A folder in which the file has this name; the first call makes it.
  [[nodiscard]] std::filesystem::path FolderOf(const std::string& name) const {
    const std::filesystem::path folder = folder_ / (name + ".folder");
    if (std::filesystem::create_directory(folder)) {
      std::filesystem::create_symlink(path(), folder / name);
    }
    return folder;
  }

 private:
  int descriptor_;
  std::filesystem::path folder_;
};

}  // namespace handcraft::testing
