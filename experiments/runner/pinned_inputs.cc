// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/pinned_inputs.h"

#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInputs = "inputs";
constexpr const char* kCells = "cells";  // begun when all inputs are pinned

// The first lines in which two texts differ, "(nothing)" past an end.
std::pair<std::string, std::string> FirstDifference(std::string_view before, std::string_view now) {
  std::istringstream before_stream{std::string(before)};
  std::istringstream now_stream{std::string(now)};
  std::string before_line;
  std::string now_line;
  while (true) {
    const bool has_before = static_cast<bool>(std::getline(before_stream, before_line));
    const bool has_now = static_cast<bool>(std::getline(now_stream, now_line));
    if (!has_before) before_line = "(nothing)";
    if (!has_now) now_line = "(nothing)";
    if (before_line != now_line || (!has_before && !has_now)) return {before_line, now_line};
  }
}

}  // namespace

PinnedInputs::PinnedInputs(fs::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (KindOf(folder_) != PathKind::kFolder) {
    throw Error({.path = folder_.string(),
                 .reason = "cannot create the folder: " +
                           (error ? error.message() : "a file of this name is in the way")});
  }
  if (KindOf(folder_ / kInputs) != PathKind::kFolder && !fs::is_empty(folder_)) {
    throw Error({.kind = Error::Kind::kUsage,
                 .path = folder_.string(),
                 .reason = "holds something else than the results of a study",
                 .remedy = "give a new folder, or one that a study has begun"});
  }
  fs::create_directory(folder_ / kInputs, error);
  if (KindOf(folder_ / kInputs) != PathKind::kFolder) {
    throw Error({.path = folder_.string(), .reason = "cannot write into the folder"});
  }
}

void PinnedInputs::Pin(std::string_view name, std::string_view text) const {
  const fs::path file = folder_ / kInputs / name;
  if (!Exists(file)) {
    if (Exists(folder_ / kCells)) {
      throw Error({.path = file.string(),
                   .reason = "is missing, and what the finished cells were made of is not known",
                   .remedy = "give a new folder"});
    }
    WriteFileAtomically(file, text);
    return;
  }
  const std::string before = ReadTextFile(file);
  if (before == text) return;
  const auto [before_line, now_line] = FirstDifference(before, text);
  throw Error({.path = folder_.string(),
               .reason = fmt::format(
                   "was begun with another input \"{}\": {}, now {}", name, before_line, now_line),
               .remedy = "give a new folder, or the inputs that it was begun with"});
}

}  // namespace handcraft::experiments
