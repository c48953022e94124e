// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/grasp_library/grasp_library.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "lib/core/check.h"
#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::grasp_library {
namespace {

using features::GraspLibrary;

// The same angle in [0, 2π).
double InOneTurn(double angle_rad) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double angle = std::fmod(angle_rad, kTurn);
  const double positive = angle < 0.0 ? angle + kTurn : angle;
  return positive < kTurn ? positive : 0.0;
}

template <class Values>
void Append(std::vector<double>& to, const Values& values) {
  to.insert(to.end(), values.begin(), values.end());
}

void AddViews(const TrainingSet& set, std::size_t object_class, GraspLibrary& library) {
  std::vector<double> moments;
  for (const SeenView& view : set.views) {
    if (view.object_class != object_class) continue;
    library.view_angles_rad.push_back(InOneTurn(view.angle_rad));
    Append(library.view_normals, view.description.normal);
    Append(moments, view.description.moments);
  }
  if (moments.empty()) {
    throw Error({.reason = fmt::format("class {} has no view", set.classes[object_class]),
                 .remedy = "add views of it, or leave its demonstrations out"});
  }
  Append(library.view_moments, moments);
  Append(library.moment_scales, features::MomentScales(moments));
  library.view_begins.push_back(static_cast<std::int32_t>(library.view_angles_rad.size()));
}

// The poses shown at one angle, as a tree.
void AddAngle(double angle_rad, const std::vector<const ShownPose*>& poses, GraspLibrary& library) {
  std::vector<features::Vector3> positions_m;
  features::Vector3 mean_m{};
  for (const ShownPose* pose : poses) {
    features::Vector3& p = positions_m.emplace_back(pose->position_m);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p[axis] -= pose->mean_m[axis];
      mean_m[axis] += pose->mean_m[axis] / static_cast<double>(poses.size());
    }
  }
  library.shown_angles_rad.push_back(angle_rad);
  Append(library.shown_means_m, mean_m);
  for (const std::size_t i : features::TreeOrder(positions_m)) {
    Append(library.positions_m, positions_m[i]);
    const features::Quaternion& q = poses[i]->rotation;
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (const double part : q) library.rotations.push_back(part / length);
    library.numbers.push_back(poses[i]->number);
  }
  library.pose_begins.push_back(static_cast<std::int32_t>(library.numbers.size()));
}

void AddPoses(const TrainingSet& set, std::size_t object_class, GraspLibrary& library) {
  std::map<double, std::vector<const ShownPose*>> by_angle;
  for (const ShownPose& pose : set.poses) {
    if (pose.object_class == object_class) by_angle[InOneTurn(pose.angle_rad)].push_back(&pose);
  }
  if (by_angle.empty()) {
    throw Error({.reason = fmt::format("class {} has no demonstration", set.classes[object_class]),
                 .remedy = "show poses for it, or leave its views out"});
  }
  for (const auto& [angle_rad, poses] : by_angle) AddAngle(angle_rad, poses, library);
  library.angle_begins.push_back(static_cast<std::int32_t>(library.shown_angles_rad.size()));
}

void CheckClasses(const TrainingSet& set) {
  if (set.classes.empty()) throw Error({.reason = "there is no class to learn"});
  const auto is_known = [&set](const auto& item) { return item.object_class < set.classes.size(); };
  HC_CHECK(std::all_of(set.views.begin(), set.views.end(), is_known), set.classes.size());
  HC_CHECK(std::all_of(set.poses.begin(), set.poses.end(), is_known), set.classes.size());
}

}  // namespace

void Options::Validate() const {
  RequireOption(num_candidates >= 0 && num_candidates <= static_cast<int>(features::kMaxCandidates),
                "grasp_library::Options.num_candidates",
                num_candidates,
                fmt::format("from 0 to {}", features::kMaxCandidates));
  RequireOption(angle_weight >= 0.0 && angle_weight <= 1e6,
                "grasp_library::Options.angle_weight",
                angle_weight,
                "from 0 to 1e6");
  RequireOption(rejection_distance_m >= 0.0 && rejection_distance_m <= 100.0,
                "grasp_library::Options.rejection_distance_m",
                rejection_distance_m,
                "from 0 to 100");
}

GraspLibrary TrainGraspLibrary(const TrainingSet& set, const Options& options) {
  options.Validate();
  CheckClasses(set);
  GraspLibrary library;
  library.rule = {.moments = options.compared_moments,
                  .num_candidates = static_cast<std::size_t>(options.num_candidates),
                  .angle_weight = options.angle_weight};
  library.view_begins = library.angle_begins = library.pose_begins = {0};
  for (std::size_t c = 0; c < set.classes.size(); ++c) {
    AddViews(set, c, library);
    AddPoses(set, c, library);
  }
  if (options.rejection_distance_m > 0.0) {
    library.rejection_distance_m = options.rejection_distance_m;
  }
  return library;
}

}  // namespace handcraft::grasp_library
