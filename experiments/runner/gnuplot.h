// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace handcraft::experiments {

/// Text inside double quotes for gnuplot; what would end them or the line is left out, so that no
/// name becomes a command.
[[nodiscard]] std::string GnuplotText(const std::string& text);

/// Six digits; NaN as gnuplot has it.
[[nodiscard]] std::string GnuplotNumber(double value);

/// The colour of a series as a quoted text; the seventh has that of the first.
[[nodiscard]] std::string GnuplotColour(std::size_t series);

/// How a line is drawn at a value that was aimed at.
inline constexpr const char* kGnuplotTargetLine =
    "linewidth 1.5 dashtype 2 linecolor rgb \"#23262b\"";

/// Commands that draw by `plot_command` into NAME.svg and NAME.pdf beside the program.
[[nodiscard]] std::string GnuplotOutputs(const std::string& plot_command, const std::string& name);

/// How a run of gnuplot ended.
enum class GnuplotOutcome { kDone, kFailed, kNoGnuplot };

/// Runs gnuplot on the program, from its folder.
[[nodiscard]] GnuplotOutcome RunGnuplot(const std::filesystem::path& program);

}  // namespace handcraft::experiments
