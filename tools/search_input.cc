// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/search_input.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/depth_cloud.h"
#include "datasets/synthetic/camera_file.h"
#include "datasets/synthetic/depth_cloud.h"
#include "experiments/evaluation/json_text.h"
#include "lib/core/error.h"
#include "lib/perception/image_io.h"
#include "lib/perception/stereo_matching.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using datasets::OrganisedCloud;
using synthetic::CameraFile;

constexpr double kMillimetre = 0.001;
constexpr float kNearest_m = 0.4F;
constexpr float kFarthest_m = 2.0F;

[[noreturn]] void RefuseSize(const std::string& path, int width, int height, const Image& image) {
  throw Error({.path = path,
               .reason = fmt::format("{} × {} pixels; the picture has {} × {}",
                                     width,
                                     height,
                                     image.width(),
                                     image.height())});
}

CameraFile ReadCamera(const SearchInput& input, const Image& image) {
  CameraFile file = synthetic::ReadCameraFile(input.camera);
  const synthetic::PinholeCamera& camera = file.camera;
  if (camera.width_px != image.width() || camera.height_px != image.height()) {
    RefuseSize(input.camera, camera.width_px, camera.height_px, image);
  }
  return file;
}

OrganisedCloud CloudOfDepthPicture(const SearchInput& input, const Image& image) {
  const synthetic::PinholeCamera camera = ReadCamera(input, image).camera;
  const BasicImage<std::uint16_t> depth = perception::ReadImage16(input.depth);
  if (depth.width() != image.width() || depth.height() != image.height()) {
    RefuseSize(input.depth, depth.width(), depth.height(), image);
  }
  const datasets::Pinhole pinhole{.fx_px = static_cast<double>(camera.focal_px),
                                  .fy_px = static_cast<double>(camera.focal_px),
                                  .cx_px = static_cast<double>(camera.centre_u_px),
                                  .cy_px = static_cast<double>(camera.centre_v_px)};
  return datasets::CloudOfDepth(depth, kMillimetre, pinhole, Eigen::Isometry3d::Identity());
}

// From two pictures in memory.
OrganisedCloud MatchedCloud(const Image& left,
                            const Image& right,
                            perception::StereoMatcher matcher,
                            int num_disparities,
                            const CameraFile& file) {
  const FloatImage disparity_px = perception::MatchPair(left, right, matcher, num_disparities);
  return synthetic::CloudFromDepth(
      perception::DepthOfDisparity(
          disparity_px, file.camera.focal_px, *file.baseline_m, kFarthest_m),
      file.camera);
}

OrganisedCloud CloudOfPair(const SearchInput& input,
                           const Image& image,
                           std::optional<perception::SearchStage>* matching) {
  const CameraFile file = ReadCamera(input, image);
  if (!file.baseline_m) {
    throw Error({.path = input.camera,
                 .reason = "no baseline_m in [camera]",
                 .remedy = "say how far apart the two cameras are [m]"});
  }
  const Image right = perception::ReadImage(input.right);
  if (right.width() != image.width() || right.height() != image.height()) {
    RefuseSize(input.right, right.width(), right.height(), image);
  }
  const int num_disparities =
      perception::NumDisparities(file.camera.focal_px, *file.baseline_m, kNearest_m);
  if (num_disparities >= image.width()) {
    throw Error(
        {.path = input.camera,
         .reason = fmt::format(
             "{} disparities; the picture has {} columns", num_disparities, image.width())});
  }
  const auto start = std::chrono::steady_clock::now();
  OrganisedCloud cloud = MatchedCloud(image,
                                      right,
                                      input.stereo_method == SearchInput::kBlock
                                          ? perception::StereoMatcher::kBlock
                                          : perception::StereoMatcher::kSemiGlobal,
                                      num_disparities,
                                      file);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  if (matching != nullptr) {
    const auto num_points =
        std::count_if(cloud.points.begin(), cloud.points.end(), datasets::IsMeasured);
    *matching = {.name = "matched",
                 .num_pixels = static_cast<std::size_t>(num_points),
                 .time_ms = time.count()};
  }
  return cloud;
}

void AddFile(CLI::App& command,
             const std::string& name,
             std::string& path,
             const std::string& description) {
  command.add_option(name, path, description)->type_name("FILE")->group(kPictureGroup);
}

// Above `low`, at most `high`, as `rule` says it.
CLI::Validator Within(double low, double high, const char* rule) {
  return CheckNumber<double>(
      [=](double value) -> std::string { return value > low && value <= high ? "" : rule; });
}

[[noreturn]] void RefuseOptions(const std::string& reason) {
  throw Error({.kind = Error::Kind::kUsage, .reason = reason});
}

// The options of the table go with depth, and upwards is a direction.
void RequireTableFits(const SearchInput& input) {
  if (!input.IsGiven()) {
    const std::string rule = " needs --cloud, --depth or --right";
    if (!input.up.empty()) RefuseOptions("--up" + rule);
    if (input.up_angle_deg) RefuseOptions("--up-angle" + rule);
    if (input.table_distance_m) RefuseOptions("--table-distance" + rule);
    return;
  }
  const perception::SearchRegionOptions options = RegionOptions(input);
  const Eigen::Vector3f& up = options.table.up;
  if (!std::isfinite(up.norm()) || up.norm() <= 0.0F) {
    RefuseOptions(fmt::format(
        "--up is {} {} {}; it must be of a finite length above 0", up.x(), up.y(), up.z()));
  }
  options.Validate();
}

// Where depth comes from.
void AddDepthSources(CLI::App& command, SearchInput& input) {
  AddFile(command,
          "--cloud",
          input.cloud,
          "Look only at what stands on the table, by the picture's cloud: PCD, organised or with "
          "an index of the pixel for each point, as the Cornell data have it");
  AddFile(command, "--depth", input.depth, "The same by a depth picture: PNG of 16 bits [mm]");
  AddFile(command, "--right", input.right, "The same by the right picture of a rectified pair");
  AddFile(command,
          "--camera",
          input.camera,
          "TOML file whose table [camera] has the intrinsics (--depth, --right) and the baseline");
  command
      .add_option(
          "--cloud-unit",
          input.cloud_unit_m,
          "One unit of the cloud's coordinates [m]; without: 1, and 0.001 for a file of the "
          "Cornell data")
      ->check(Within(0.0, 1000.0, "above 0 and at most 1000"))
      ->type_name("METRES")
      ->group(kPictureGroup);
  command
      .add_option("--stereo-method",
                  input.stereo_method,
                  "How --right is matched: semi-global (OpenCV's StereoSGBM) or block (StereoBM)")
      ->check(CLI::IsMember({SearchInput::kSemiGlobal, SearchInput::kBlock}))
      ->capture_default_str()
      ->group(kPictureGroup);
}

}  // namespace

std::vector<std::filesystem::path> SearchInput::Files() const {
  std::vector<std::filesystem::path> files;
  for (const std::string& file : {cloud, depth, right, camera}) {
    if (!file.empty()) files.emplace_back(file);
  }
  return files;
}

void AddSearchOptions(CLI::App& command, SearchInput& input) {
  AddDepthSources(command, input);
  command
      .add_option("--up", input.up, "Upwards in the cloud's frame; 0 0 1, or 0 -1 0 of a camera")
      ->type_name("X Y Z")
      ->expected(3)
      ->group(kPictureGroup);
  command
      .add_option("--up-angle",
                  input.up_angle_deg,
                  "A table's normal is at most so far from upwards [deg]; without: 10")
      ->transform(Within(0.0, 90.0, "above 0 and at most 90"))
      ->type_name("NUMBER")
      ->group(kPictureGroup);
  command
      .add_option("--table-distance",
                  input.table_distance_m,
                  "Points nearer to the table belong to it [m]; without: 0.01")
      ->transform(Within(0.0, 1.0, "above 0 and at most 1"))
      ->type_name("NUMBER")
      ->group(kPictureGroup);
}

void RequireSearchFits(const SearchInput& input, std::size_t num_inputs) {
  const int num_sources =
      (input.cloud.empty() ? 0 : 1) + (input.depth.empty() ? 0 : 1) + (input.right.empty() ? 0 : 1);
  if (num_sources > 1) RefuseOptions("--cloud, --depth and --right exclude each other");
  if (num_sources == 1 && num_inputs != 1) {
    RefuseOptions("--cloud, --depth and --right belong to one picture; give one INPUT");
  }
  const bool needs_camera = !input.depth.empty() || !input.right.empty();
  if (needs_camera && input.camera.empty()) RefuseOptions("--depth and --right need --camera");
  if (!needs_camera && !input.camera.empty())
    RefuseOptions("--camera is read by --depth and --right alone");
  if (input.cloud.empty() && input.cloud_unit_m) RefuseOptions("--cloud-unit needs --cloud");
  if (input.right.empty() && input.stereo_method != SearchInput::kSemiGlobal) {
    RefuseOptions("--stereo-method needs --right");
  }
  RequireTableFits(input);
}

OrganisedCloud CloudFor(const SearchInput& input,
                        const Image& image,
                        std::optional<perception::SearchStage>* matching) {
  if (!input.cloud.empty()) {
    return datasets::ReadCloudOfPicture(input.cloud, datasets::SizeOf(image), input.cloud_unit_m);
  }
  return input.depth.empty() ? CloudOfPair(input, image, matching)
                             : CloudOfDepthPicture(input, image);
}

perception::SearchRegionOptions RegionOptions(const SearchInput& input) {
  perception::SearchRegionOptions options;
  if (!input.up.empty()) {
    options.table.up = {input.up[0], input.up[1], input.up[2]};
  } else if (input.cloud.empty()) {
    options.table.up = {0.0F, -1.0F, 0.0F};
  }
  options.table.max_angle_rad =
      static_cast<float>(input.up_angle_deg.value_or(10.0) * std::numbers::pi / 180.0);
  options.table.epsilon_m = static_cast<float>(input.table_distance_m.value_or(0.01));
  return options;
}

nlohmann::ordered_json SearchJson(const perception::SearchRegion& region) {
  nlohmann::ordered_json json = {{"found", region.HasRegion()},
                                 {"message", perception::MessageOf(region.state)},
                                 {"crop",
                                  {{"u_px", region.crop.u_px},
                                   {"v_px", region.crop.v_px},
                                   {"width_px", region.crop.width},
                                   {"height_px", region.crop.height}}},
                                 {"table", nlohmann::ordered_json::array()},
                                 {"stages", nlohmann::ordered_json::array()}};
  for (const perception::Plane& plane : region.table) {
    const auto number = [](float value) { return experiments::ShortestDouble(value); };
    json["table"].push_back(
        {{"normal", {number(plane.normal.x()), number(plane.normal.y()), number(plane.normal.z())}},
         {"offset_m", number(plane.offset_m)}});
  }
  for (const perception::SearchStage& stage : region.stages) {
    json["stages"].push_back(
        {{"name", stage.name}, {"num_pixels", stage.num_pixels}, {"time_ms", stage.time_ms}});
  }
  return json;
}

std::string SearchTable(const perception::SearchRegion& region) {
  TextTable table({"stage", "pixels", "time [ms]"});
  double total_ms = 0.0;
  for (const perception::SearchStage& stage : region.stages) {
    table.AddRow({std::string(stage.name),
                  std::to_string(stage.num_pixels),
                  fmt::format("{:.2f}", stage.time_ms)});
    total_ms += stage.time_ms;
  }
  table.AddRow({"all", "-", fmt::format("{:.2f}", total_ms)});
  return table.ToText();
}

}  // namespace handcraft::tools
