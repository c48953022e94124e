// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/python_peer.h"

#include <stdio.h>

#include <string>

#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// What the command prints; nothing when it fails.
std::optional<std::string> OutputOf(const std::string& command) {
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::string output;
  char buffer[256];
  while (::fgets(buffer, sizeof buffer, pipe) != nullptr) output += buffer;
  if (::pclose(pipe) != 0) return std::nullopt;
  return output;
}

}  // namespace

std::optional<nlohmann::json> RunPythonPeer(std::string_view script,
                                            const std::vector<std::filesystem::path>& arguments,
                                            const std::filesystem::path& scratch,
                                            int num_threads) {
  const std::filesystem::path program = scratch / "peer.py";
  WriteFileAtomically(program, script);
  std::string settings;
  for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"}) {
    settings.append(name).append("=").append(std::to_string(num_threads)).append(" ");
  }
  std::string words = " " + Quoted(program.string());
  for (const std::filesystem::path& argument : arguments) {
    words.append(" ").append(Quoted(argument.string()));
  }
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    std::string command = settings;
    command.append(python).append(words).append(" 2>/dev/null");
    const auto output = OutputOf(command);
    if (!output) continue;
    nlohmann::json json = nlohmann::json::parse(*output, nullptr, false);
    if (!json.is_discarded()) return json;
  }
  return std::nullopt;
}

}  // namespace handcraft::experiments
