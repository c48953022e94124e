// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/gnuplot.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace handcraft::experiments {
namespace {

constexpr int kCannotPrepare = 126;
constexpr int kCannotStart = 127;

// In the child: only calls that are allowed between fork and exec.
[[noreturn]] void BecomeGnuplot(const char* folder, const char* file) {
  const int nowhere = ::open("/dev/null", O_RDWR);
  if (nowhere < 0 || ::dup2(nowhere, STDOUT_FILENO) < 0 || ::dup2(nowhere, STDERR_FILENO) < 0 ||
      ::chdir(folder) != 0) {
    ::_exit(kCannotPrepare);
  }
  ::execlp("gnuplot", "gnuplot", file, nullptr);
  ::_exit(kCannotStart);
}

}  // namespace

std::string GnuplotText(const std::string& text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter != '"' && letter != '\\' && letter != '\n' && letter != '`') quoted += letter;
  }
  return quoted + "\"";
}

std::string GnuplotNumber(double value) {
  return std::isnan(value) ? std::string("NaN") : fmt::format("{:.6g}", value);
}

std::string GnuplotColour(std::size_t series) {
  constexpr std::array kColours = {
      "#14766f", "#c25a24", "#5566a8", "#8a7a2b", "#8b4a7d", "#5f6670", "#4fa3d1", "#e0a63a"};
  return fmt::format("\"{}\"", kColours[series % kColours.size()]);
}

std::string GnuplotOutputs(const std::string& plot_command, const std::string& name) {
  std::string text;
  for (const auto& [terminal, ending] :
       {std::pair("svg size 960,420 noenhanced background \"#ffffff\"", "svg"),
        std::pair("pdfcairo size 9.6in,4.2in noenhanced", "pdf")}) {
    text += fmt::format("set terminal {}\nset output {}\n{}unset output\n",
                        terminal,
                        GnuplotText(name + "." + ending),
                        plot_command);
  }
  return text;
}

GnuplotOutcome RunGnuplot(const std::filesystem::path& program) {
  const std::string folder = std::filesystem::absolute(program).parent_path().string();
  const std::string file = program.filename().string();
  const pid_t child = ::fork();
  if (child < 0) return GnuplotOutcome::kFailed;
  if (child == 0) BecomeGnuplot(folder.c_str(), file.c_str());
  int status = 0;
  if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return GnuplotOutcome::kFailed;
  if (WEXITSTATUS(status) == kCannotStart) return GnuplotOutcome::kNoGnuplot;
  return WEXITSTATUS(status) == 0 ? GnuplotOutcome::kDone : GnuplotOutcome::kFailed;
}

}  // namespace handcraft::experiments
