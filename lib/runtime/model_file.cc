// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/runtime/model_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

namespace handcraft::runtime {
namespace {

using Bytes = std::vector<std::uint8_t>;

class Descriptor {
 public:
  explicit Descriptor(const char* path) noexcept : value_(::open(path, O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int value() const noexcept { return value_; }

 private:
  int value_;
};

ModelError FileError(const char* doing, const char* path, int error_number) noexcept {
  char buffer[80];
  // The GNU version, which may leave the buffer alone.
  const char* reason = ::strerror_r(error_number, buffer, sizeof buffer);
  return MakeError(HC_ERROR_FILE, kNoOffset, "cannot %s: %s: %s", doing, reason, path);
}

ModelError TooLarge(std::size_t max_bytes) noexcept {
  return MakeError(HC_ERROR_FORMAT,
                   0,
                   "not a model file: larger than the %zu bytes a model may have",
                   max_bytes);
}

// Reads to the end, wherever that is: the file may grow, or be a pipe of unknown size.
Result<Bytes> ReadAll(int descriptor, const char* path, std::size_t guess, std::size_t max_bytes) {
  Bytes bytes(guess + 1);
  std::size_t used = 0;
  while (true) {
    const ssize_t count = ::read(descriptor, bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return FileError("read", path, errno);
    if (count == 0) break;
    used += static_cast<std::size_t>(count);
    if (used > max_bytes) return TooLarge(max_bytes);
    if (used == bytes.size()) bytes.resize(std::min(2 * used, max_bytes) + 1);
  }
  bytes.resize(used);
  return bytes;
}

}  // namespace

Result<Bytes> ReadModelFile(const char* path, std::size_t max_bytes) noexcept {
  try {
    const Descriptor file(path);
    if (file.value() < 0) return FileError("open", path, errno);
    struct stat status {};
    if (::fstat(file.value(), &status) != 0) return FileError("read", path, errno);
    if (S_ISDIR(status.st_mode)) return FileError("read", path, EISDIR);
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > max_bytes) return TooLarge(max_bytes);
    return ReadAll(file.value(), path, size, max_bytes);
  } catch (const std::bad_alloc&) {
    return MakeError(HC_ERROR_MEMORY, kNoOffset, "out of memory while reading the file");
  }
}

}  // namespace handcraft::runtime
