// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace handcraft::testing {

/// The numbers of a file of tests/data/cloud_histograms, of which its README.md tells.
inline std::vector<double> ReferenceNumbers(const std::string& name) {
  std::ifstream file(std::filesystem::path(HANDCRAFT_SOURCE_DIR) / "tests/data/cloud_histograms" /
                     name);
  std::vector<double> numbers;
  for (double number = 0.0; file >> number;) numbers.push_back(number);
  return numbers;
}

}  // namespace handcraft::testing
