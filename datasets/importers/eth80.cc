// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/eth80.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/importers/flat_cloud.h"
#include "datasets/importers/object_mask.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

// What a picture's name says.
struct ViewName {
  std::string object;
  std::string object_class;
  int polar_deg = 0;
  double angle_deg = 0.0;
};

// 022 stands for 22.5, 090 for 90.
double ToAngle(int rounded_deg) {
  constexpr double kStep_deg = 22.5;
  const double multiple = std::round(rounded_deg / kStep_deg) * kStep_deg;
  const double angle_deg = std::abs(multiple - rounded_deg) <= 0.5 ? multiple : rounded_deg;
  return std::fmod(angle_deg, 360.0);
}

// "cup3-090-022".
std::optional<ViewName> ParseName(const std::string& stem) {
  static const std::regex kPattern("(([^0-9].*?)[0-9]+)-([0-9]{3})-([0-9]{3})");
  std::smatch match;
  if (!std::regex_match(stem, match, kPattern)) return std::nullopt;
  return ViewName{match[1], match[2], std::stoi(match[3]), ToAngle(std::stoi(match[4]))};
}

constexpr std::string_view kMapEnd = "-map";

// Whether the file is a silhouette rather than a picture.
bool IsMap(const fs::path& file) {
  return file.parent_path().filename() == "maps" && file.extension() == ".png" &&
         file.stem().string().ends_with(kMapEnd);
}

fs::path MapOf(const fs::path& image) {
  return image.parent_path() / "maps" / (image.stem().string() + std::string(kMapEnd) + ".png");
}

// Of a picture or a silhouette: the path of its picture without the extension.
fs::path ViewOf(const fs::path& file) {
  if (!IsMap(file)) return file.parent_path() / file.stem();
  const std::string stem = file.stem().string();
  return file.parent_path().parent_path() / stem.substr(0, stem.size() - kMapEnd.size());
}

// Nothing when the file is neither a picture of the data nor a silhouette.
std::optional<ViewName> ParseFile(const fs::path& file) {
  if (!IsNamedLikeAPicture(file)) return std::nullopt;
  return ParseName(ViewOf(file).filename().string());
}

SourcePicture Describe(const fs::path& file, const fs::path& relative, const ViewName& name) {
  return {.path = file,
          .image = relative.generic_string(),
          .mask = fs::path(relative).replace_extension(".png").generic_string(),
          .object_class = name.object_class,
          .instance = name.object,
          .angle_deg = name.angle_deg,
          .make_mask = [map = MapOf(file)](int width, int height) {
            return ReadObjectMask(map, width, height);
          }};
}

// What was found, from the angles of the pictures and silhouettes.
std::string TextOf(const std::set<int>& polar_angles) {
  std::string found;
  for (const int angle : polar_angles) found += " " + std::to_string(angle);
  return found.empty() ? " none" : found;
}

}  // namespace

void Eth80Options::Validate() const {
  RequireOption(
      polar_deg >= 0 && polar_deg <= 90, "Eth80Options.polar_deg", polar_deg, "from 0 to 90");
}

SourceSet ListEth80(const fs::path& source, const Eth80Options& options) {
  options.Validate();
  SourceSet set;
  Omissions omissions;
  std::set<int> polar_angles;
  std::set<fs::path> with_picture;
  const auto is_meant = [&](const fs::path& path) {
    const std::optional<ViewName> name = ParseFile(path);
    return name && name->polar_deg == options.polar_deg;
  };
  std::vector<fs::path> files = ListFiles(source, std::numeric_limits<int>::max(), is_meant);
  std::stable_partition(files.begin(), files.end(), [](const fs::path& x) { return !IsMap(x); });
  for (const fs::path& file : files) {
    const std::optional<ViewName> name = ParseFile(file);
    if (!name) continue;
    polar_angles.insert(name->polar_deg);
    if (name->polar_deg != options.polar_deg) continue;
    const bool is_first = with_picture.insert(ViewOf(file)).second;
    if (IsMap(file)) {
      if (is_first) omissions.LeaveOut(file, "no picture OBJECT-PPP-AAA.png of this silhouette");
    } else if (!HasFile(MapOf(file))) {
      omissions.LeaveOut(file, "no silhouette maps/OBJECT-PPP-AAA-map.png of this picture");
    } else {
      set.pictures.push_back(Describe(file, file.lexically_relative(source), *name));
    }
  }
  omissions.Conclude(
      set,
      {.path = source.string(),
       .reason = "no OBJECT-PPP-AAA.png with PPP = " + std::to_string(options.polar_deg) +
                 " and its silhouette; angles PPP found:" + TextOf(polar_angles),
       .remedy = "give the folder of the objects, or another angle (--polar)"});
  if (options.flat_clouds) AddFlatClouds(set);
  return set;
}

}  // namespace handcraft::datasets
