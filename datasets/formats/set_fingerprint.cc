// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/formats/set_fingerprint.h"

#include <algorithm>

#include "lib/core/file.h"
#include "lib/core/sha256.h"

namespace handcraft::datasets {

std::string FileDigest(const std::filesystem::path& path) { return Sha256Hex(ReadFile(path)); }

std::string FingerprintLine(const std::string& image, std::initializer_list<std::string> parts) {
  std::string line = std::filesystem::path(image).lexically_normal().generic_string();
  for (const std::string& part : parts) line.append(1, '\0').append(part);
  return line + '\n';
}

std::string FingerprintOf(std::vector<std::string> lines) {
  std::sort(lines.begin(), lines.end());
  Sha256 hash;
  for (const std::string& line : lines) hash.Update(line);
  return hash.HexDigest();
}

}  // namespace handcraft::datasets
