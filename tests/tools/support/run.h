// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace handcraft::tools::testing {

/// What a command left: exit code and the two streams.
struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

/// Runs `handcraft` in this process on the arguments.
[[nodiscard]] Outcome RunArgs(const std::vector<std::string>& args);

/// As RunArgs, with the line split at blanks; no quoting but '' for an empty argument.
[[nodiscard]] Outcome RunLine(const std::string& line);

}  // namespace handcraft::tools::testing
