// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/memory.h"

#include <fstream>
#include <limits>

#include "lib/core/error.h"

namespace handcraft {
namespace {

constexpr std::uint64_t kBytesPerMegabyte = 1'000'000;

}  // namespace

std::optional<std::uint64_t> AvailableMemory(const std::filesystem::path& meminfo) {
  std::ifstream file(meminfo);
  std::string name;
  std::uint64_t kibibytes = 0;
  while (file >> name >> kibibytes) {
    if (name == "MemAvailable:") return kibibytes * 1024;
    file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  return std::nullopt;
}

void RequireMemory(std::uint64_t needed,
                   std::optional<std::uint64_t> available,
                   const std::string& what,
                   const std::string& remedy) {
  if (!available || needed <= *available) return;
  throw Error({.reason = what + " needs " +
                         std::to_string((needed + kBytesPerMegabyte - 1) / kBytesPerMegabyte) +
                         " MB of memory, of which " +
                         std::to_string(*available / kBytesPerMegabyte) + " MB are available",
               .remedy = remedy});
}

}  // namespace handcraft
