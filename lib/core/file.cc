// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "lib/core/error.h"

namespace handcraft {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const fs::path& path, const std::string& doing, int error_number) {
  Error::Details details{.path = path.string(),
                         .reason = "cannot " + doing + ": " + std::strerror(error_number)};
  if (error_number == ENOSPC) details.remedy = "free some space or write to another disk";
  if (error_number == ENOENT) details.remedy = "check the path";
  if (error_number == EISDIR) details.remedy = "give a file in it";
  throw Error(std::move(details));
}

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int value) noexcept : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int value() const noexcept { return value_; }
  [[nodiscard]] int Close() noexcept {
    const int result = ::close(value_);
    value_ = -1;
    return result;
  }

 private:
  int value_;
};

void WriteAll(const Descriptor& file, const fs::path& path, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.value(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) Fail(path, "write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

std::string SixLetters() {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz012345";
  std::array<std::uint8_t, 6> bytes{};
  if (::getentropy(bytes.data(), bytes.size()) != 0) return "temp00";
  std::string letters;
  for (const std::uint8_t byte : bytes) letters += kLetters[byte % kLetters.size()];
  return letters;
}

// A temporary file, six letters behind the target's name, that goes away unless it was renamed into
// place. mkstemp would leave the permissions to umask, which cannot be read without being set for
// all threads; open applies it.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : path_(target.string() + '.' + SixLetters()),
        descriptor_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)) {
    if (descriptor_.value() < 0) Fail(target, "create the file", errno);
  }
  ~TemporaryFile() {
    if (!renamed_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void Write(const fs::path& target, std::span<const std::uint8_t> bytes) {
    WriteAll(descriptor_, target, bytes);
  }

  void MoveTo(const fs::path& target) {
    if (::fsync(descriptor_.value()) != 0) Fail(target, "write", errno);
    if (descriptor_.Close() != 0) Fail(target, "write", errno);
    if (::rename(path_.c_str(), target.c_str()) != 0) Fail(target, "replace the file", errno);
    renamed_ = true;
  }

 private:
  std::string path_;
  Descriptor descriptor_;
  bool renamed_ = false;
};

}  // namespace

std::vector<std::uint8_t> ReadFile(const fs::path& path, std::size_t max_bytes) {
  // Without O_NONBLOCK a pipe that nobody writes to would never open.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.value() < 0) Fail(path, "open", errno);
  struct stat status {};
  if (::fstat(file.value(), &status) != 0) Fail(path, "read", errno);
  if (S_ISDIR(status.st_mode)) Fail(path, "read", EISDIR);
  if (!S_ISREG(status.st_mode)) {
    throw Error({.path = path.string(),
                 .reason = "is a pipe or a device; a file is due",
                 .remedy = "save what it gives to a file"});
  }

  std::vector<std::uint8_t> bytes;
  const auto expected = static_cast<std::size_t>(status.st_size);
  if (expected <= max_bytes) bytes.reserve(expected + 1);
  std::size_t used = 0;
  while (true) {
    // One byte more than expected, so that the usual file ends at the first read after its last.
    bytes.resize(used + std::max<std::size_t>(expected + 1 - std::min(used, expected), 1 << 12));
    const ssize_t count = ::read(file.value(), bytes.data() + used, bytes.size() - used);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) Fail(path, "read", errno);
    used += static_cast<std::size_t>(count);
    if (used > max_bytes) {
      throw Error({.path = path.string(),
                   .reason = "larger than the " + std::to_string(max_bytes) + " bytes allowed"});
    }
    if (count == 0) break;
  }
  bytes.resize(used);
  return bytes;
}

std::string ReadTextFile(const fs::path& path) {
  const std::vector<std::uint8_t> bytes = ReadFile(path);
  return {bytes.begin(), bytes.end()};
}

void WriteFileAtomically(const fs::path& path, std::span<const std::uint8_t> bytes) {
  std::error_code no_such_file;
  const fs::file_status status = fs::status(path, no_such_file);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
    const Descriptor stream(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (stream.value() < 0) Fail(path, "open", errno);
    return WriteAll(stream, path, bytes);
  }
  const fs::path target = fs::exists(status) ? fs::canonical(path) : path;
  TemporaryFile file(target);
  file.Write(path, bytes);
  file.MoveTo(target);
}

void WriteFileAtomically(const fs::path& path, std::string_view text) {
  WriteFileAtomically(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace handcraft
