// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <sstream>
#include <string>

namespace handcraft::internal {

/// Throws std::logic_error("file:line: check failed: condition [names = values]").
[[noreturn]] void FailCheck(const char* file,
                            int line,
                            const char* condition,
                            const char* names,
                            const std::string& values);

template <class... Values>
std::string JoinValues(const Values&... values) {
  std::ostringstream stream;
  [[maybe_unused]] const char* separator = "";
  ((stream << separator << values, separator = ", "), ...);
  return stream.str();
}

}  // namespace handcraft::internal

/// Refuses a caller's mistake: HC_CHECK(rows == labels, rows, labels) throws std::logic_error that
/// names file, line, condition and the values listed. Always on. Not for files or user input
/// (handcraft::Error) and never reached on the robot.
#define HC_CHECK(condition, ...)                                                        \
  do {                                                                                  \
    if (!(condition)) {                                                                 \
      ::handcraft::internal::FailCheck(__FILE__,                                        \
                                       __LINE__,                                        \
                                       #condition,                                      \
                                       #__VA_ARGS__,                                    \
                                       ::handcraft::internal::JoinValues(__VA_ARGS__)); \
    }                                                                                   \
  } while (false)
