// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/demonstrator.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>

#include "lib/core/error.h"
#include "lib/core/option_rules.h"

namespace handcraft::synthetic {
namespace {

using Eigen::Isometry3f;
using Eigen::Quaternionf;
using Eigen::Vector3f;

float Apart(const Grasp& a, const Grasp& b, float metres_per_radian) {
  const Isometry3f& pose_a = a.object_from_grasp;
  const Isometry3f& pose_b = b.object_from_grasp;
  const float angle_rad =
      Quaternionf(pose_a.linear()).angularDistance(Quaternionf(pose_b.linear()));
  return (pose_a.translation() - pose_b.translation()).norm() + metres_per_radian * angle_rad;
}

// Farthest-point selection (Gonzalez 1985): within twice the best possible cover.
std::vector<Grasp> Spread(const std::vector<Grasp>& grasps,
                          const DemonstratorOptions& options,
                          Rng& rng) {
  std::vector<Grasp> chosen;
  std::vector<float> nearest(grasps.size(), std::numeric_limits<float>::infinity());
  std::size_t next = rng.UniformInt(grasps.size());
  const std::size_t count =
      std::min(static_cast<std::size_t>(options.num_favourites), grasps.size());
  while (chosen.size() < count) {
    chosen.push_back(grasps[next]);
    for (std::size_t i = 0; i < grasps.size(); ++i) {
      nearest[i] = std::min(nearest[i], Apart(grasps[i], chosen.back(), options.metres_per_radian));
    }
    next = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) -
                                    nearest.begin());
  }
  return chosen;
}

Vector3f DrawNormals(Rng& rng, float sd) {
  const auto draw = [&] { return sd * static_cast<float>(rng.Normal()); };
  const float x = draw();
  const float y = draw();
  return {x, y, draw()};
}

Isometry3f DrawScatter(const DemonstratorOptions& options, Rng& rng) {
  const Vector3f shift_m = DrawNormals(rng, options.position_sd_m);
  const Vector3f turn = DrawNormals(rng, options.rotation_sd_rad);
  const float angle_rad = turn.norm();
  const Vector3f axis = angle_rad > 0.0F ? Vector3f(turn / angle_rad) : Vector3f::UnitX();
  return Eigen::Translation3f(shift_m) * Isometry3f(Eigen::AngleAxisf(angle_rad, axis));
}

}  // namespace

void DemonstratorOptions::Validate() const {
  RequireOption(num_favourites >= 1 && num_favourites <= 1000,
                "DemonstratorOptions.num_favourites",
                num_favourites,
                "from 1 to 1000");
  RequireOption(position_sd_m >= 0.0F && position_sd_m <= 0.1F,
                "DemonstratorOptions.position_sd_m",
                position_sd_m,
                "from 0 to 0.1");
  RequireOption(rotation_sd_rad >= 0.0F && rotation_sd_rad <= 1.0F,
                "DemonstratorOptions.rotation_sd_rad",
                rotation_sd_rad,
                "from 0 to 1");
  RequireOption(metres_per_radian > 0.0F && metres_per_radian <= 10.0F,
                "DemonstratorOptions.metres_per_radian",
                metres_per_radian,
                "in (0, 10]");
  RequireOption(num_tries >= 1 && num_tries <= 1000000,
                "DemonstratorOptions.num_tries",
                num_tries,
                "from 1 to 1000000");
}

Isometry3f InObject(const datasets::EndEffectorPose& base_from_grasp,
                    const Isometry3f& base_from_object) {
  return base_from_object.inverse() * base_from_grasp.ToIsometry().cast<float>();
}

Demonstrator::Demonstrator(const GraspCheck& check,
                           std::span<const Grasp> grasps,
                           const PlacedBeforeArm& place,
                           const DemonstratorOptions& options,
                           Rng& rng)
    : check_(&check),
      place_(place),
      arm_in_object_(place.arm_in_base.In(place.base_from_object.inverse())),
      options_(options) {
  options.Validate();
  std::vector<Grasp> within_reach;
  std::copy_if(
      grasps.begin(), grasps.end(), std::back_inserter(within_reach), [&](const Grasp& grasp) {
        return arm_in_object_.Check(grasp.object_from_grasp, check.gripper()) == GraspFault::kNone;
      });
  if (within_reach.empty()) {
    throw Error(
        {.kind = Error::Kind::kNoResult,
         .reason = "none of " + std::to_string(grasps.size()) + " grasps is within the arm's reach",
         .remedy = "place the object nearer to the robot"});
  }
  favourites_ = Spread(within_reach, options, rng);
  double sum = 0.0;
  for (std::size_t i = 0; i < favourites_.size(); ++i) {
    sum -= std::log(1.0 - rng.Uniform());
    weight_up_to_.push_back(sum);
  }
}

const Grasp& Demonstrator::DrawFavourite(Rng& rng) const {
  const double weight = rng.Uniform() * weight_up_to_.back();
  const auto found = std::upper_bound(weight_up_to_.begin(), weight_up_to_.end() - 1, weight);
  return favourites_[static_cast<std::size_t>(found - weight_up_to_.begin())];
}

ShownGrasp Demonstrator::Show(Rng& rng, GraspCounts& counts) const {
  for (int tries = 0; tries < options_.num_tries; ++tries) {
    const Isometry3f scattered = DrawFavourite(rng).object_from_grasp * DrawScatter(options_, rng);
    const auto pose =
        datasets::EndEffectorPose::Rounded((place_.base_from_object * scattered).cast<double>());
    const Isometry3f object_from_grasp = InObject(pose, place_.base_from_object);
    GraspFault fault = arm_in_object_.Check(object_from_grasp, check_->gripper());
    ContactPlaces contacts;
    if (fault == GraspFault::kNone) {
      const GraspOutcome outcome = check_->Close(object_from_grasp);
      fault = outcome.fault;
      contacts = outcome.contacts;
    }
    counts.Add(fault);
    if (fault == GraspFault::kNone) return {pose, contacts};
  }
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "no pose that holds the object in " + std::to_string(options_.num_tries) +
                         " tries",
               .remedy = "scatter the poses less"});
}

}  // namespace handcraft::synthetic
