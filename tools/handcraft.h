// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <iosfwd>
#include <span>

namespace handcraft::tools {

/// The whole `handcraft` command: runs it on the arguments after the program's name and returns
/// its exit code: 0 done, 2 wrong use, 3 bad input, 4 no result, 1 a bug of ours.
/// Results go to `out`; errors, warnings and progress to `err`. Never throws.
[[nodiscard]] int RunHandcraft(std::span<const char* const> args,
                               std::ostream& out,
                               std::ostream& err) noexcept;

}  // namespace handcraft::tools
