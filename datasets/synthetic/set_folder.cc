// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/set_folder.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
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

// By which option of the command line a key of the file is chosen.
struct ChosenBy {
  std::string_view key;
  std::string_view option;
};
constexpr std::array<ChosenBy, 17> kChosenBy = {{{"kind", "the same command"},
                                                 {"family", "--family"},
                                                 {"sensor", "--sensor"},
                                                 {"seed", "--seed"},
                                                 {"surroundings", "--surroundings"},
                                                 {"meshes", "--meshes, the files unchanged,"},
                                                 {"num_images", "--images or --size"},
                                                 {"num_views", "--views"},
                                                 {"num_configurations", "--configurations"},
                                                 {"poses_per_view", "--poses or --size"},
                                                 {"holds_per_view", "--holds"},
                                                 {"camera_noise_m", "--camera-noise-m"},
                                                 {"camera_noise_deg", "--camera-noise-deg"},
                                                 {"width_px", "--camera"},
                                                 {"height_px", "--camera"},
                                                 {"focal_px", "--camera"},
                                                 {"baseline_m", "--stereo or --camera"}}};

// The first line that differs, or that one of them alone has.
struct Difference {
  std::size_t line = 0;
  std::string there = {};
  std::string here = {};
};

Difference FirstDifference(const std::string& there, std::string_view here) {
  std::istringstream there_lines(there);
  std::istringstream here_lines{std::string(here)};
  Difference difference;
  do {
    ++difference.line;
    if (!std::getline(there_lines, difference.there)) difference.there = "nothing";
    if (!std::getline(here_lines, difference.here)) difference.here = "nothing";
  } while (difference.there == difference.here && difference.there != "nothing");
  return difference;
}

[[noreturn]] void RefuseOtherOptions(const fs::path& file,
                                     const std::string& there,
                                     std::string_view here) {
  const Difference difference = FirstDifference(there, here);
  const auto chosen = std::find_if(kChosenBy.begin(), kChosenBy.end(), [&](const ChosenBy& by) {
    const std::string start = std::string(by.key) + " = ";
    return difference.there.starts_with(start) || difference.here.starts_with(start);
  });
  const std::string option =
      chosen == kChosenBy.end() ? "the options" : std::string(chosen->option);
  throw Error({.kind = Error::Kind::kUsage,
               .path = file.string(),
               .line = difference.line,
               .reason = "tells of a set made with other options: " + difference.there +
                         " there, " + difference.here + " here",
               .remedy = "give " + option + " as there, or another folder"});
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
    if (there != parameters) RefuseOtherOptions(file, there, parameters);
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
