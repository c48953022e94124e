// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/progress_bar.h"

#include <algorithm>
#include <ostream>

#include <fmt/format.h>

namespace handcraft::tools {
namespace {

constexpr std::size_t kBarWidth = 20;
constexpr std::string_view kClearLine = "\r\x1b[K";

}  // namespace

ProgressBar::~ProgressBar() { Clear(); }

Progress ProgressBar::Callback() {
  if (!console_.interactive) return {};
  return [this](std::string_view stage, std::size_t done, std::size_t total) {
    Show(stage, done, total);
  };
}

void ProgressBar::Clear() {
  if (shown_.empty()) return;
  console_.err << kClearLine << std::flush;
  shown_.clear();
}

// Written only when the text changes, so at most a hundred times a stage of known length.
void ProgressBar::Show(std::string_view stage, std::size_t done, std::size_t total) {
  std::string line;
  if (total == 0) {
    line = fmt::format("{}  {}", stage, done);
  } else {
    const std::size_t reached = std::min(done, total);
    const std::size_t filled = reached * kBarWidth / total;
    line = fmt::format("{}  [{:#<{}}{:-<{}}] {:3} %",
                       stage,
                       "",
                       filled,
                       "",
                       kBarWidth - filled,
                       reached * 100 / total);
  }
  if (line == shown_) return;
  console_.err << kClearLine << line << std::flush;
  shown_ = std::move(line);
}

}  // namespace handcraft::tools
