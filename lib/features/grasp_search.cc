// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/grasp_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace handcraft::features {
namespace {

constexpr double kWeightDistanceM = 0.001;

// The number of the shown angle that is the least turn away, of equal ones the first.
std::size_t NearestShownAngle(const ShownClass& shown, double object_angle_rad) noexcept {
  std::size_t best = 0;
  for (std::size_t i = 1; i < shown.shown_angles_rad.size(); ++i) {
    if (std::fabs(TurnBetween(object_angle_rad, shown.shown_angles_rad[i])) <
        std::fabs(TurnBetween(object_angle_rad, shown.shown_angles_rad[best]))) {
      best = i;
    }
  }
  return best;
}

// Mean position and rotation of rows, weighted by distance.
struct MeanPose {
  Vector3 position_m = {};
  Quaternion rotation = {};
};

MeanPose MeanOf(const ShownClass& shown,
                std::size_t first_row,
                std::span<const Neighbour> neighbours) noexcept {
  std::array<Quaternion, kMaxGraspNeighbours> rotations;
  std::array<double, kMaxGraspNeighbours> weights;
  Vector3 position_m{};
  double sum = 0.0;
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    const std::size_t row = first_row + neighbours[i].row;
    std::copy_n(shown.rotations.data() + 4 * row, 4, rotations[i].begin());
    weights[i] = 1.0 / (std::sqrt(neighbours[i].squared_distance_m2) + kWeightDistanceM);
    sum += weights[i];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      position_m[axis] += weights[i] * shown.positions_m[3 * row + axis];
    }
  }
  for (double& coordinate : position_m) coordinate /= sum;
  return {position_m,
          MeanRotation(std::span(rotations).first(neighbours.size()),
                       std::span(weights).first(neighbours.size()))};
}

}  // namespace

double TurnBetween(double from_rad, double to_rad) noexcept {
  return std::remainder(to_rad - from_rad, 2.0 * std::numbers::pi);
}

Vector3 TurnedAboutZ(const Vector3& p, double angle_rad) noexcept {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
}

std::size_t RankGraspsAt(const ShownClass& shown,
                         double object_angle_rad,
                         const Vector3& mean_m,
                         const GraspRequest& request,
                         std::span<FoundGrasp> grasps) noexcept {
  const std::size_t angle = NearestShownAngle(shown, object_angle_rad);
  const double turn_rad = TurnBetween(object_angle_rad, shown.shown_angles_rad[angle]);
  const Vector3 p_p = TurnedAboutZ({request.point_m[0] - mean_m[0],
                                    request.point_m[1] - mean_m[1],
                                    request.point_m[2] - mean_m[2]},
                                   turn_rad);  // Eq. 4.6
  const auto first = static_cast<std::size_t>(shown.begins[angle]);
  const auto count = static_cast<std::size_t>(shown.begins[angle + 1]) - first;
  const PositionTree tree{.rows = shown.positions_m.subspan(3 * first, 3 * count),
                          .numbers = shown.numbers.subspan(first, count)};
  std::array<Neighbour, kMaxRankedGrasps + kMaxGraspNeighbours - 1> places;
  const std::size_t num_wanted = std::min(grasps.size(), kMaxRankedGrasps);
  const std::span<const Neighbour> found(
      places.data(),
      FindNearest(tree, p_p, std::span(places).first(num_wanted + request.num_neighbours - 1)));
  const std::size_t num_grasps = std::min(num_wanted, found.size());
  for (std::size_t i = 0; i < num_grasps; ++i) {
    const MeanPose mean =
        MeanOf(shown, first, found.subspan(i, std::min(request.num_neighbours, found.size() - i)));
    const Vector3 back = TurnedAboutZ(mean.position_m, -turn_rad);
    grasps[i] = {.view = 0,
                 .object_angle_rad = object_angle_rad,
                 .turn_rad = turn_rad,
                 .position_m = {back[0] + mean_m[0], back[1] + mean_m[1], back[2] + mean_m[2]},
                 .rotation = Product(TurnAboutZ(-turn_rad), mean.rotation),  // Eq. 4.7
                 .distance_m = std::sqrt(found[i].squared_distance_m2),
                 .number = found[i].number};
  }
  return num_grasps;
}

FoundGrasp FindGraspAt(const ShownClass& shown,
                       double object_angle_rad,
                       const Vector3& mean_m,
                       const GraspRequest& request) noexcept {
  FoundGrasp found;
  static_cast<void>(RankGraspsAt(shown, object_angle_rad, mean_m, request, {&found, 1}));
  return found;
}

FoundGrasp FindGrasp(const ShownClass& shown,
                     const RotationRule& rule,
                     const ViewDescription& view,
                     const GraspRequest& request) noexcept {
  const std::size_t nearest = NearestView(view, shown.views, rule);
  FoundGrasp found = FindGraspAt(shown, shown.view_angles_rad[nearest], view.mean_m, request);
  found.view = nearest;
  return found;
}

}  // namespace handcraft::features
