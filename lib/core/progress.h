// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace handcraft {

/// How a library tells how far it has come: stage name, units done, units in all (0: unknown).
/// May be empty. Called from the thread that called the library, never from a worker.
using Progress = std::function<void(std::string_view stage, std::size_t done, std::size_t total)>;

inline void Report(const Progress& progress,
                   std::string_view stage,
                   std::size_t done,
                   std::size_t total) {
  if (progress) progress(stage, done, total);
}

}  // namespace handcraft
