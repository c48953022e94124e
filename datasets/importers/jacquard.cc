// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/jacquard.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "lib/core/error.h"
#include "lib/core/file.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kImageEnd = "_RGB.png";
constexpr std::string_view kGraspsEnd = "_grasps.txt";

// x, y, theta, opening, jaw.
using Grasp = std::array<double, 5>;

Grasp ParseGrasp(const fs::path& path, std::size_t line_number, std::string_view line) {
  constexpr double kLargest = 1e6;
  Grasp grasp{};
  const char* at = line.data();
  const char* const end = line.data() + line.size();
  bool is_good = true;
  for (std::size_t i = 0; is_good && i < grasp.size(); ++i) {
    if (i > 0) is_good = at != end && *at++ == ';';
    if (!is_good) break;
    const auto [stop, error] = std::from_chars(at, end, grasp[i]);
    at = stop;
    is_good = error == std::errc() && std::abs(grasp[i]) <= kLargest;  // false for NaN
  }
  if (!is_good || at != end) {
    throw Error({.path = path.string(),
                 .line = line_number,
                 .reason = "'" + std::string(line.substr(0, 40)) +
                           "' where a grasp \"x;y;theta;opening;jaw\" is due"});
  }
  return grasp;
}

GraspRectangle ToRectangle(const Grasp& grasp) {
  const auto [x, y, theta_deg, opening, jaw] = grasp;
  const double angle = theta_deg * std::numbers::pi / 180.0;
  const auto corner = [&, x = x, y = y, opening = opening, jaw = jaw](double s, double t) {
    const double along = s * opening / 2;
    const double across = t * jaw / 2;
    return std::array{x + along * std::cos(angle) - across * std::sin(angle),
                      y + along * std::sin(angle) + across * std::cos(angle)};
  };
  return {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
}

bool IsImage(const fs::path& path) { return path.filename().string().ends_with(kImageEnd); }
bool IsLabels(const fs::path& path) { return path.filename().string().ends_with(kGraspsEnd); }

// "0_1a2b" is the first scene of object 1a2b.
std::string ObjectOf(const std::string& scene) {
  const std::size_t at = scene.find('_');
  const bool is_numbered = at != std::string::npos && at > 0 && at + 1 < scene.size() &&
                           scene.find_first_not_of("0123456789") == at;
  return is_numbered ? scene.substr(at + 1) : scene;
}

// NAME_RGB.png → NAME_grasps.txt, or back.
fs::path WithOtherEnd(const fs::path& file, std::string_view end, std::string_view other) {
  std::string name = file.filename().string();
  name.replace(name.size() - end.size(), end.size(), other);
  return file.parent_path() / name;
}

SourcePicture Describe(const fs::path& image,
                       const fs::path& relative,
                       const fs::path& labels,
                       const GraspMaskOptions& options) {
  const std::string scene = WithOtherEnd(image, kImageEnd, "").filename().string();
  const std::vector<GraspRectangle> grasps = ReadJacquardGrasps(labels);
  return {
      .path = image,
      .image = relative.generic_string(),
      .mask = (relative.parent_path() / (scene + ".png")).generic_string(),
      .instance = ObjectOf(scene),
      .make_mask =
          [labels, grasps, options](int width, int height) {
            RequireWithinPicture(labels, grasps, width, height);
            return MakeGraspMask(width, height, grasps, {}, options);
          },
      .read_rectangles = [grasps] { return MarkedRectangles{.positive = grasps, .negative = {}}; }};
}

void AddPicture(const fs::path& image,
                const fs::path& source,
                const GraspMaskOptions& options,
                SourceSet& set,
                Omissions& omissions) {
  const fs::path labels = WithOtherEnd(image, kImageEnd, kGraspsEnd);
  if (!HasFile(labels)) {
    omissions.LeaveOut(image, "no *_grasps.txt beside it");
    return;
  }
  SourcePicture picture = Describe(image, image.lexically_relative(source), labels, options);
  if (picture.read_rectangles().positive.empty()) {
    omissions.LeaveOut(labels, kNoUsableRectangle);
  } else {
    set.pictures.push_back(std::move(picture));
  }
}

}  // namespace

std::vector<GraspRectangle> ReadJacquardGrasps(const fs::path& path) {
  constexpr double kSmallest_px2 = 1.0;
  const std::string text = ReadTextFile(path);
  std::vector<GraspRectangle> rectangles;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    ++line_number;
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    if (line.empty()) continue;
    const GraspRectangle rectangle = ToRectangle(ParseGrasp(path, line_number, line));
    if (RectangleArea(rectangle) >= kSmallest_px2) rectangles.push_back(rectangle);
  }
  return rectangles;
}

SourceSet ListJacquard(const fs::path& source, const GraspMaskOptions& options) {
  options.Validate();
  SourceSet set;
  Omissions omissions;
  std::size_t num_images = 0;
  std::size_t num_labels = 0;
  const auto is_meant = [](const fs::path& path) { return IsImage(path) || IsLabels(path); };
  for (const fs::path& file : ListFiles(source, std::numeric_limits<int>::max(), is_meant)) {
    if (IsImage(file)) {
      ++num_images;
      AddPicture(file, source, options, set, omissions);
    } else if (IsLabels(file)) {
      ++num_labels;
      if (HasFile(WithOtherEnd(file, kGraspsEnd, kImageEnd))) continue;
      omissions.LeaveOut(file, "no *_RGB.png beside it");
    }
  }
  omissions.Conclude(set,
                     {.path = source.string(),
                      .reason = "no *_RGB.png with grasps in its *_grasps.txt; found " +
                                std::to_string(num_images) + " pictures and " +
                                std::to_string(num_labels) + " files of grasps",
                      .remedy = "give the folder that holds the folders of the objects"});
  return set;
}

}  // namespace handcraft::datasets
