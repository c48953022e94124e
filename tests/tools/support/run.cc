// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/tools/support/run.h"

#include <sstream>

#include "tools/handcraft.h"

namespace handcraft::tools::testing {

Outcome RunArgs(const std::vector<std::string>& args) {
  std::vector<const char*> pointers;
  pointers.reserve(args.size());
  for (const std::string& arg : args) pointers.push_back(arg.c_str());
  std::ostringstream out;
  std::ostringstream err;
  const int code = RunHandcraft(pointers, out, err);
  return {.code = code, .out = out.str(), .err = err.str()};
}

Outcome RunLine(const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> args;
  for (std::string word; words >> word;) args.push_back(word == "''" ? "" : word);
  return RunArgs(args);
}

}  // namespace handcraft::tools::testing
