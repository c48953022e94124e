// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

namespace handcraft {

/// What went wrong in the world outside the program, told to the person who can mend it.
///
/// Thrown by the offline side (files, data sets, options); caught once, in `main`, which turns
/// `kind` into the exit code. The runtime on the robot never throws: it returns error values.
/// Read by people as `path:line: reason (remedy)`, on one line (OnOneLine) whatever names hold.
class Error : public std::runtime_error {
 public:
  enum class Kind {
    kUsage,     ///< The command line or an option is wrong: exit code 2.
    kBadInput,  ///< A file or data set is wrong: exit code 3.
    kNoResult,  ///< Input was fine, but there is nothing to return (not converged): exit code 4.
  };

  /// Every part but the reason may be left empty.
  struct Details {
    Kind kind = Kind::kBadInput;
    std::string path = {};                           ///< File or folder at fault.
    std::optional<std::size_t> line = std::nullopt;  ///< 1-based line in a text file.
    std::optional<std::size_t> byte = std::nullopt;  ///< 0-based offset in a binary file.
    std::string reason;                              ///< What was found, and what was expected.
    std::string remedy = {};                         ///< What to do about it.
  };

  explicit Error(Details details);

  [[nodiscard]] const Details& details() const noexcept { return details_; }

 private:
  Details details_;
};

/// The process exit code for an error: 2 usage, 3 bad input, 4 no result (1 is left for our bugs).
[[nodiscard]] int ExitCode(Error::Kind kind) noexcept;

}  // namespace handcraft
