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
#include <string>
#include <string_view>
#include <system_error>

#include <Eigen/Geometry>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/depth_cloud.h"
#include "datasets/importers/object_mask.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr double kFocal_px = 570.3;
constexpr double kUnit_m = 0.001;

// The files of a view, and what its name says.
struct ViewFiles {
  fs::path stem;  // path without _crop.png
  std::string object_class, instance;
  int video = 0;

  [[nodiscard]] fs::path With(const char* end) const { return stem.string() + end; }
};

std::optional<ViewFiles> ParseName(const fs::path& file) {
  static const std::regex kPattern("((.+)_[0-9]{1,4})_([0-9]{1,4})_[0-9]+_crop\\.png");
  const std::string name = file.filename().string();
  std::smatch match;
  if (!std::regex_match(name, match, kPattern)) return std::nullopt;
  constexpr std::string_view kEnd = "_crop.png";
  return ViewFiles{.stem = file.parent_path() / name.substr(0, name.size() - kEnd.size()),
                   .object_class = match[2],
                   .instance = match[1],
                   .video = std::stoi(match[3])};
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
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  const double turn_deg = ReadNumbers<1>(path, "the turn in degrees")[0];
  const double angle_deg = turn_deg - 360.0 * std::floor(turn_deg / 360.0);
  return angle_deg < 360.0 ? angle_deg : 0.0;  // of a tiny negative one
}

}  // namespace

SourceSet ListWashington(const fs::path& source) {
  SourceSet set;
  std::size_t num_files = 0;
  for (const fs::path& file : ListFiles(source, std::numeric_limits<int>::max())) {
    ++num_files;
    const std::optional<ViewFiles> files = ParseName(file);
    std::error_code ignored;
    if (!files || !fs::is_regular_file(files->With("_maskcrop.png"), ignored)) continue;
    const std::string relative = file.lexically_relative(source).generic_string();
    SourcePicture view{.path = file,
                       .image = relative,
                       .mask = relative,
                       .object_class = files->object_class,
                       .instance = files->instance,
                       .angle_deg = ReadAngle(files->With("_pose.txt")),
                       .make_mask = [path = files->With("_maskcrop.png")](int width, int height) {
                         return ReadObjectMask(path, width, height);
                       }};
    if (fs::is_regular_file(files->With("_depthcrop.png"), ignored)) {
      view.make_cloud = [files = *files](int width, int height) {
        return ReadCloud(files, width, height);
      };
    }
    set.pictures.push_back(std::move(view));
  }
  if (set.pictures.empty()) {
    throw Error({.path = source.string(),
                 .reason = "no CLASS_N_VIDEO_FRAME_crop.png with a _maskcrop.png; found " +
                           std::to_string(num_files) + " files",
                 .remedy = "give the unpacked folder of the cropped pictures (rgbd-dataset)"});
  }
  return set;
}

}  // namespace handcraft::datasets
