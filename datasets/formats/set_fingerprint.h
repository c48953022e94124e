// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

/// The parts of which every data set's fingerprint is made: docs/datasets.md "Fingerprint".
namespace handcraft::datasets {

/// SHA-256 of a file's bytes, in hexadecimal. Throws Error when it cannot be read.
[[nodiscard]] std::string FileDigest(const std::filesystem::path& path);

/// A picture's line: the image's path as it is compared ("./a//b.png" is "a/b.png"), then each
/// part behind a zero byte, then a line end.
[[nodiscard]] std::string FingerprintLine(const std::string& image,
                                          std::initializer_list<std::string> parts);

/// SHA-256, in hexadecimal, over the lines sorted by their bytes.
[[nodiscard]] std::string FingerprintOf(std::vector<std::string> lines);

}  // namespace handcraft::datasets
