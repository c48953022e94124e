// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/eth80.h"

#include <cmath>
#include <limits>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <system_error>

#include "datasets/importers/flat_cloud.h"
#include "datasets/importers/object_mask.h"
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

fs::path FindSilhouette(const fs::path& image) {
  fs::path map = image.parent_path() / "maps" / (image.stem().string() + "-map.png");
  std::error_code ignored;
  if (fs::is_regular_file(map, ignored)) return map;
  throw Error({.path = image.string(),
               .reason = "has no silhouette: expected " + map.string(),
               .remedy = "unpack the folder maps beside the pictures"});
}

}  // namespace

void Eth80Options::Validate() const {
  RequireOption(
      polar_deg >= 0 && polar_deg <= 90, "Eth80Options.polar_deg", polar_deg, "from 0 to 90");
}

SourceSet ListEth80(const fs::path& source, const Eth80Options& options) {
  options.Validate();
  SourceSet set;
  std::set<int> polar_angles;
  for (const fs::path& file : ListFiles(source, std::numeric_limits<int>::max())) {
    const std::optional<ViewName> name = ParseName(file.stem().string());
    if (!name || !IsNamedLikeAPicture(file)) continue;
    polar_angles.insert(name->polar_deg);
    if (name->polar_deg != options.polar_deg) continue;
    const fs::path relative = file.lexically_relative(source);
    set.pictures.push_back({.path = file,
                            .image = relative.generic_string(),
                            .mask = fs::path(relative).replace_extension(".png").generic_string(),
                            .object_class = name->object_class,
                            .instance = name->object,
                            .angle_deg = name->angle_deg,
                            .make_mask = [map = FindSilhouette(file)](int width, int height) {
                              return ReadObjectMask(map, width, height);
                            }});
  }
  if (set.pictures.empty()) {
    std::string found;
    for (const int angle : polar_angles) found += " " + std::to_string(angle);
    throw Error({.path = source.string(),
                 .reason = "no OBJECT-PPP-AAA.png with PPP = " + std::to_string(options.polar_deg) +
                           "; angles PPP found:" + (found.empty() ? " none" : found),
                 .remedy = "give the folder of the objects, or another angle (--polar)"});
  }
  if (options.flat_clouds) AddFlatClouds(set);
  return set;
}

}  // namespace handcraft::datasets
