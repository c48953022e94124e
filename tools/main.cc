// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iostream>

#include "tools/handcraft.h"

int main(int argc, char** argv) {
  const std::span<const char* const> all(argv, static_cast<std::size_t>(argc));
  return handcraft::tools::RunHandcraft(all.subspan(all.empty() ? 0 : 1), std::cout, std::cerr);
}
