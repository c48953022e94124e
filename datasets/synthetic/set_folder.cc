// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/set_folder.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "datasets/formats/required_list.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/core/path_kind.h"

namespace handcraft::synthetic {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kWrittenEndings = {".png", ".toml", ".csv", ".pcd"};
constexpr std::size_t kTemporaryEndingSize = 7;  // a dot and six letters, as mkstemp makes them

// What a killed run may have left of a file that was being written.
void RemoveTemporaryFiles(const fs::path& folder) {
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    const std::string inner = entry.path().stem().extension().string();
    if (ending.size() == kTemporaryEndingSize &&
        std::find(kWrittenEndings.begin(), kWrittenEndings.end(), inner) != kWrittenEndings.end()) {
      left.push_back(entry.path());
    }
  }
  for (const fs::path& path : left) fs::remove(path);
}

[[noreturn]] void RefuseFolder(const fs::path& path, std::string reason, std::string remedy) {
  throw Error({.kind = Error::Kind::kUsage,
               .path = path.string(),
               .reason = std::move(reason),
               .remedy = std::move(remedy)});
}

// "seed = 1 there, seed = 2 here": the first line that differs, or that one of them alone has.
std::string FirstDifference(const std::string& there, std::string_view here) {
  std::istringstream there_lines(there);
  std::istringstream here_lines{std::string(here)};
  std::string there_line;
  std::string here_line;
  do {
    if (!std::getline(there_lines, there_line)) there_line = "nothing";
    if (!std::getline(here_lines, here_line)) here_line = "nothing";
  } while (there_line == here_line && there_line != "nothing");
  return there_line + " there, " + here_line + " here";
}

void MakeOrTakeUp(const fs::path& out,
                  std::string_view parameters,
                  std::span<const std::string_view> subfolders) {
  const fs::path file = out / datasets::kMadeUpFileName;
  if (KindOf(out) == PathKind::kFile) RefuseFolder(out, "is not a folder", "choose another name");
  if (KindOf(file) != PathKind::kNothing) {
    const std::string there = ReadTextFile(file);
    if (there.size() < parameters.size() && parameters.starts_with(there)) {
      throw Error({.path = file.string(),
                   .reason = "is cut after " + std::to_string(there.size()) + " bytes",
                   .remedy = "remove the folder, or bring the file back"});
    }
    if (there != parameters) {
      RefuseFolder(file,
                   "tells of a set made with other options: " + FirstDifference(there, parameters),
                   "give those, or another folder");
    }
  } else if (Exists(out) && !fs::is_empty(out)) {
    RefuseFolder(
        out, "is there already and is not an empty folder", "remove it or choose another name");
  }
  fs::create_directory(out);
  RemoveTemporaryFiles(out);
  if (!Exists(file)) WriteFileAtomically(file, parameters);
  for (const std::string_view folder : subfolders) {
    fs::create_directory(out / folder);
    RemoveTemporaryFiles(out / folder);
  }
}

}  // namespace

void PrepareSetFolder(const fs::path& out,
                      std::string_view parameters,
                      std::span<const std::string_view> subfolders) {
  try {
    MakeOrTakeUp(out, parameters, subfolders);
  } catch (const fs::filesystem_error& error) {
    throw Error({.path = out.string(),
                 .reason = "cannot make the folder: " + error.code().message(),
                 .remedy = "the folder it is to lie in must exist and be writable"});
  }
}

}  // namespace handcraft::synthetic
