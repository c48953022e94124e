// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/washington.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/depth_cloud.h"
#include "datasets/importers/object_mask.h"
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr double kFocal_px = 570.3;
constexpr double kUnit_m = 0.001;

// Which view a file is of: what their names have in common, and what that says.
struct ViewFiles {
  fs::path stem;  // path without _crop.png and the like
  std::string object_class, instance;
  int video = 0;

  [[nodiscard]] fs::path With(const char* end) const { return stem.string() + end; }
};

std::optional<ViewFiles> ParseName(const fs::path& file) {
  static const std::regex kPattern(
      "(((.+)_[0-9]{1,4})_([0-9]{1,4})_[0-9]+)_((crop|depthcrop|maskcrop)\\.png|loc\\.txt)");
  const std::string name = file.filename().string();
  std::smatch match;
  if (!std::regex_match(name, match, kPattern)) return std::nullopt;
  return ViewFiles{.stem = file.parent_path() / match[1].str(),
                   .object_class = match[3],
                   .instance = match[2],
                   .video = std::stoi(match[4])};
}

// The numbers of a file, between commas and blanks; as many as asked for.
template <std::size_t kCount>
std::array<double, kCount> ReadNumbers(const fs::path& path, const std::string& what) {
  const std::string text = ReadTextFile(path);
  std::array<double, kCount> numbers{};
  constexpr std::string_view kBetween = " ,\t\r\n";
  std::size_t at = 0;
  for (double& number : numbers) {
    at = std::min(text.find_first_not_of(kBetween, at), text.size());
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) {
      throw Error(
          {.path = path.string(), .byte = at, .reason = "no number where " + what + " is due"});
    }
    at = static_cast<std::size_t>(end - text.data());
  }
  if (text.find_first_not_of(kBetween, at) != std::string::npos) {
    throw Error({.path = path.string(), .byte = at, .reason = "more than " + what});
  }
  return numbers;
}

// x forward, y left, z up from the camera's optical frame, which looks down by so much.
Eigen::Isometry3d LevelFromCamera(double down_rad) {
  Eigen::Isometry3d level = Eigen::Isometry3d::Identity();
  level.linear() << 0, -std::sin(down_rad), std::cos(down_rad),  //
      -1, 0, 0,                                                  //
      0, -std::cos(down_rad), -std::sin(down_rad);
  return level;
}

// By how much the camera of a video looks down [rad].
double TiltOf(int video) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return video == 1   ? 30.0 * kDegree
         : video == 2 ? 45.0 * kDegree
         : video == 4 ? 60.0 * kDegree
                      : 0;
}

OrganisedCloud ReadCloud(const ViewFiles& files, int width, int height) {
  const fs::path path = files.With("_depthcrop.png");
  const BasicImage<std::uint16_t> depth = perception::ReadImage16(path);
  RequireSameSize(path, "the depth", {depth.width(), depth.height()}, {width, height});
  const auto [x, y] = ReadNumbers<2>(files.With("_loc.txt"), "\"x,y\" of the first pixel");
  // Theirs count from 1: column u of the crop is column u + x, from 1, of the picture.
  const Pinhole camera{kFocal_px, kFocal_px, 320.0 - x, 240.0 - y};
  return CloudOfDepth(depth, kUnit_m, camera, LevelFromCamera(TiltOf(files.video)));
}

std::optional<double> ReadAngle(const fs::path& path) {
  if (!HasFile(path)) return std::nullopt;
  const double turn_deg = ReadNumbers<1>(path, "the turn in degrees")[0];
  const double angle_deg = turn_deg - 360.0 * std::floor(turn_deg / 360.0);
  return angle_deg < 360.0 ? angle_deg : 0.0;  // of a tiny negative one
}

SourcePicture Describe(const ViewFiles& files, const fs::path& source) {
  const fs::path image = files.With("_crop.png");
  const std::string relative = image.lexically_relative(source).generic_string();
  SourcePicture view{.path = image,
                     .image = relative,
                     .mask = relative,
                     .object_class = files.object_class,
                     .instance = files.instance,
                     .angle_deg = ReadAngle(files.With("_pose.txt")),
                     .make_mask = [path = files.With("_maskcrop.png")](int width, int height) {
                       return ReadObjectMask(path, width, height);
                     }};
  if (HasFile(files.With("_depthcrop.png")) && HasFile(files.With("_loc.txt"))) {
    view.make_cloud = [files](int width, int height) { return ReadCloud(files, width, height); };
  }
  return view;
}

// Adds the view that `file` is one of; the first of them in the order of names tells what is there.
void AddView(const fs::path& file,
             const ViewFiles& files,
             const fs::path& source,
             SourceSet& set,
             Omissions& omissions) {
  if (!HasFile(files.With("_crop.png"))) {
    omissions.LeaveOut(file, "no *_crop.png beside it");
  } else if (!HasFile(files.With("_maskcrop.png"))) {
    omissions.LeaveOut(file, "no *_maskcrop.png beside it");
  } else {
    set.pictures.push_back(Describe(files, source));
  }
}

void TellOfLack(const std::vector<SourcePicture>& pictures, Omissions& omissions) {
  std::vector<fs::path> without_cloud;
  std::vector<fs::path> without_angle;
  for (const SourcePicture& picture : pictures) {
    if (!picture.make_cloud) without_cloud.push_back(picture.path);
    if (!picture.angle_deg) without_angle.push_back(picture.path);
  }
  omissions.GoWithoutWhatOthersHave(
      without_cloud, pictures.size(), "its cloud", "no *_depthcrop.png, or no *_loc.txt for it");
  omissions.GoWithoutWhatOthersHave(
      without_angle, pictures.size(), "its angle", "no *_pose.txt beside it");
}

}  // namespace

SourceSet ListWashington(const fs::path& source) {
  SourceSet set;
  Omissions omissions;
  std::set<fs::path> known;
  const auto is_meant = [](const fs::path& path) { return ParseName(path).has_value(); };
  const std::vector<fs::path> all = ListFiles(source, std::numeric_limits<int>::max(), is_meant);
  for (const fs::path& file : all) {
    const std::optional<ViewFiles> files = ParseName(file);
    if (!files || !known.insert(files->stem).second) continue;
    AddView(file, *files, source, set, omissions);
  }
  TellOfLack(set.pictures, omissions);
  omissions.Conclude(set,
                     {.path = source.string(),
                      .reason = "no CLASS_N_VIDEO_FRAME_crop.png with a _maskcrop.png; found " +
                                std::to_string(all.size()) + " files",
                      .remedy = "give the unpacked folder of the cropped pictures (rgbd-dataset)"});
  return set;
}

}  // namespace handcraft::datasets
