// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lib/core/progress.h"
#include "tools/console.h"

namespace handcraft::tools {

/// One line that shows how far a long piece of work has come, drawn over itself:
///   drawing samples  [########------------]  40 %
/// Draws nothing unless the console is a terminal; the line is gone when the object is.
class ProgressBar {
 public:
  explicit ProgressBar(const Console& console) noexcept : console_(console) {}
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// For the options of a library call, which this object must outlive. Empty when nothing is to
  /// be drawn.
  [[nodiscard]] Progress Callback();

  /// Takes the line away, so that something else can be printed.
  void Clear();

 private:
  void Show(std::string_view stage, std::size_t done, std::size_t total);

  const Console& console_;
  std::string shown_;
};

}  // namespace handcraft::tools
