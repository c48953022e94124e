// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/grasp_planning/grasp_plan_options.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"
#include "lib/features/grasp_search.h"
#include "lib/structured_text/toml_file.h"
#include "lib/structured_text/toml_table.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxNeighbours = features::kMaxGraspNeighbours;
constexpr int kMaxAttempts = features::kMaxRankedGrasps;
constexpr double kMaxDistanceM = 1e3;

double SquaredLength(std::span<const double> parts) {
  double squared = 0.0;
  for (const double part : parts) squared += part * part;
  return squared;
}

bool IsUnit(std::span<const double> quaternion) {
  return std::fabs(SquaredLength(quaternion) - 1.0) <= 1e-3;
}

// The numbers of an array.
std::vector<double> NumbersOf(const TomlTable& table, std::string_view key, std::size_t count) {
  const toml::array* const array = table.Node(key).as_array();
  std::vector<double> numbers;
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
    const auto number = (*array)[i].value<double>();
    if (!number || !std::isfinite(*number)) break;
    numbers.push_back(*number);
  }
  if (array == nullptr || numbers.size() != array->size() ||
      (count != 0 && numbers.size() != count)) {
    table.Fail(table.Node(key),
               count == 0 ? fmt::format("'{}' must be a list of numbers", key)
                          : fmt::format("'{}' must be a list of {} numbers", key, count));
  }
  return numbers;
}

void ReadGraspPoint(const TomlTable& file, const fs::path& folder, GraspPlanOptions& options) {
  if (!file.Has("grasp_point")) return;
  const TomlTable table = file.Table("grasp_point");
  table.AllowOnly(std::array<std::string_view, 2>{"model", "pixel"});
  if (table.Has("model")) options.grasp_point_model = folder / table.Text("model");
  if (!table.Has("pixel")) return;
  const std::vector<double> pixel = NumbersOf(table, "pixel", 2);
  for (const double side : pixel) {
    if (side >= 0.0 && side <= 1e6 && side == std::floor(side)) continue;
    table.Fail(table.Node("pixel"), "'pixel' must be column and row, whole numbers from 0");
  }
  options.grasp_pixel = {static_cast<int>(pixel[0]), static_cast<int>(pixel[1])};
}

void ReadObjectClass(const TomlTable& file, const fs::path& folder, GraspPlanOptions& options) {
  if (!file.Has("object_class")) return;
  const TomlTable table = file.Table("object_class");
  table.AllowOnly(std::array<std::string_view, 3>{"name", "model", "none_of_these"});
  if (table.Has("name")) options.object_class = table.Text("name");
  if (table.Has("model")) options.object_class_model = folder / table.Text("model");
  if (!table.Has("none_of_these")) return;
  const std::string answer = table.Text("none_of_these");
  if (answer != "refuse" && answer != "nearest") {
    table.Fail(table.Node("none_of_these"), "'none_of_these' must be \"refuse\" or \"nearest\"");
  }
  options.take_nearest_class = answer == "nearest";
}

void ReadLibrary(const TomlTable& file, const fs::path& folder, GraspPlanOptions& options) {
  if (!file.Has("grasp_library")) return;
  const TomlTable table = file.Table("grasp_library");
  table.AllowOnly(std::array<std::string_view, 5>{
      "model", "neighbours", "position", "attempts", "attempt_distance_m"});
  if (table.Has("model")) options.grasp_library = folder / table.Text("model");
  if (table.Has("neighbours")) {
    options.num_neighbours = static_cast<int>(table.Number("neighbours", 1, kMaxNeighbours));
  }
  if (table.Has("attempts")) {
    options.max_attempts = static_cast<int>(table.Number("attempts", 1, kMaxAttempts));
  }
  if (table.Has("attempt_distance_m")) {
    options.max_attempt_distance_m = table.Number("attempt_distance_m", 0, kMaxDistanceM);
  }
  if (!table.Has("position")) return;
  const std::string position = table.Text("position");
  for (const GraspPosition value : {GraspPosition::kGraspPoint, GraspPosition::kDemonstration}) {
    if (position == NameOf(value)) {
      options.position = value;
      return;
    }
  }
  table.Fail(table.Node("position"), "'position' must be \"grasp_point\" or \"demonstration\"");
}

void ReadRobot(const TomlTable& file, const fs::path& folder, GraspPlanOptions& options) {
  if (!file.Has("robot")) return;
  const TomlTable table = file.Table("robot");
  table.AllowOnly(std::array<std::string_view, 3>{"file", "any_arm", "reference"});
  if (table.Has("file")) options.robot = folder / table.Text("file");
  if (table.Has("any_arm")) {
    const auto any_arm = table.Node("any_arm").value_exact<bool>();
    if (!any_arm) table.Fail(table.Node("any_arm"), "'any_arm' must be true or false");
    options.any_arm = *any_arm;
  }
  if (table.Has("reference")) options.reference_joints = NumbersOf(table, "reference", 0);
}

void ReadHand(const TomlTable& file, GraspPlanOptions& options) {
  if (!file.Has("hand")) return;
  const TomlTable table = file.Table("hand");
  table.AllowOnly(std::array<std::string_view, 2>{"grasp_centre_m", "grasp_centre_xyzw"});
  if (table.Has("grasp_centre_m")) {
    const std::vector<double> p = NumbersOf(table, "grasp_centre_m", 3);
    std::copy(p.begin(), p.end(), options.grasp_centre_m.begin());
  }
  if (table.Has("grasp_centre_xyzw")) {
    const std::vector<double> q = NumbersOf(table, "grasp_centre_xyzw", 4);
    if (!IsUnit(q)) {
      table.Fail(table.Node("grasp_centre_xyzw"),
                 "'grasp_centre_xyzw' must be a quaternion of length 1: x, y, z, w");
    }
    std::copy(q.begin(), q.end(), options.grasp_centre_xyzw.begin());
  }
}

void RequireGiven(bool is_given, const std::string& what, const std::string& remedy) {
  if (is_given) return;
  throw Error({.kind = Error::Kind::kUsage, .reason = what + " is not told", .remedy = remedy});
}

}  // namespace

std::string_view NameOf(GraspPosition position) noexcept {
  return position == GraspPosition::kGraspPoint ? "grasp_point" : "demonstration";
}

void GraspPlanOptions::Validate() const {
  RequireGiven(!grasp_library.empty(),
               "the grasp library",
               "give --library, or model in [grasp_library] of the plan file");
  RequireGiven(!robot.empty(), "the arm", "give --robot, or file in [robot] of the plan file");
  RequireGiven(!object_class.empty() || !object_class_model.empty(),
               "the object's class",
               "give --classifier MODEL or --class NAME, or [object_class] of the plan file");
  if (!object_class.empty() && !object_class_model.empty()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "the object's class is told twice: by its name and by a model",
                 .remedy = "give one of them"});
  }
  RequireGiven(grasp_pixel.has_value() || !grasp_point_model.empty(),
               "where to grasp",
               "give --grasp-point u,v or --grasp-points MODEL, or [grasp_point] of the plan file");
  if (grasp_pixel.has_value() && !grasp_point_model.empty()) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "where to grasp is told twice: by a pixel and by a model",
                 .remedy = "give one of them"});
  }
  RequireOption(num_neighbours >= 1 && num_neighbours <= kMaxNeighbours,
                "GraspPlanOptions.num_neighbours",
                num_neighbours,
                "from 1 to 32");
  RequireOption(max_attempts >= 1 && max_attempts <= kMaxAttempts,
                "GraspPlanOptions.max_attempts",
                max_attempts,
                "from 1 to 64");
  RequireOption(max_attempt_distance_m >= 0.0 && max_attempt_distance_m <= kMaxDistanceM,
                "GraspPlanOptions.max_attempt_distance_m",
                max_attempt_distance_m,
                "from 0 to 1000");
  RequireOption(IsUnit(grasp_centre_xyzw),
                "the squared length of GraspPlanOptions.grasp_centre_xyzw",
                SquaredLength(grasp_centre_xyzw),
                "1");
}

GraspPlanOptions ReadGraspPlanFile(const fs::path& path) {
  const toml::table root = ReadTomlFile(path);
  const TomlTable file(path.string(), root, "");
  file.AllowOnly(std::array<std::string_view, 5>{
      "grasp_point", "object_class", "grasp_library", "robot", "hand"});
  const fs::path folder = path.parent_path();
  GraspPlanOptions options;
  ReadGraspPoint(file, folder, options);
  ReadObjectClass(file, folder, options);
  ReadLibrary(file, folder, options);
  ReadRobot(file, folder, options);
  ReadHand(file, options);
  return options;
}

}  // namespace handcraft::experiments
