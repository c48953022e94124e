// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/demonstration_cell.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "experiments/metrics/quantile.h"
#include "lib/core/error.h"
#include "lib/core/parallel.h"

namespace handcraft::experiments {
namespace {

using grasp_library::ShownPose;
using grasp_library::TrainingSet;

constexpr std::size_t kNumBins = 18;
constexpr double kHighShare = 0.9;

struct HeldOut {
  double distance_m = 0.0;  // to the nearest of the others
  double position_error_m = 0.0;
  double rotation_error_deg = 0.0;
  double time_ms = 0.0;
};

// The others of a pose's class: those of its own view, but it, where there are some and that is
// meant; else those of all other views.
TrainingSet OthersOf(const TrainingSet& shown, std::size_t number, HeldOutPart part) {
  const ShownPose& pose = shown.poses[number];
  TrainingSet of_view{.classes = {shown.classes[pose.object_class]}};
  for (const grasp_library::SeenView& view : shown.views) {
    if (view.object_class != pose.object_class) continue;
    of_view.views.push_back(view);
    of_view.views.back().object_class = 0;
  }
  TrainingSet of_others = of_view;
  for (std::size_t i = 0; i < shown.poses.size(); ++i) {
    const ShownPose& other = shown.poses[i];
    if (i == number || other.object_class != pose.object_class) continue;
    TrainingSet& set = other.angle_rad == pose.angle_rad ? of_view : of_others;
    set.poses.push_back(other);
    set.poses.back().object_class = 0;
  }
  return part == HeldOutPart::kDemonstration && !of_view.poses.empty() ? of_view : of_others;
}

double Distance(const features::Vector3& a, const features::Vector3& b) noexcept {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

HeldOut Find(const TrainingSet& shown, std::size_t number, const GraspSettings& settings) {
  const ShownPose& pose = shown.poses[number];
  const TrainingSet others = OthersOf(shown, number, settings.held_out);
  if (others.poses.empty()) {
    throw Error({.reason = fmt::format("no other demonstration of \"{}\" is left",
                                       shown.classes[pose.object_class]),
                 .remedy = "give several of each class, and of several views"});
  }
  const features::GraspLibrary library = grasp_library::TrainGraspLibrary(others);
  const auto start = std::chrono::steady_clock::now();
  const features::FoundGrasp found = features::FindGraspAt(
      library.Class(0),
      pose.angle_rad,
      pose.mean_m,
      {.point_m = pose.position_m, .num_neighbours = settings.num_neighbours});
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return {.distance_m = found.distance_m,
          .position_error_m = Distance(found.position_m, pose.position_m),
          .rotation_error_deg =
              features::AngleBetween(found.rotation, pose.rotation) * 180.0 / std::numbers::pi,
          .time_ms = taken.count()};
}

bool IsRight(const HeldOut& found) noexcept { return found.rotation_error_deg <= kRightHandDeg; }
bool IsKept(const HeldOut& found, const GraspSettings& settings) noexcept {
  return settings.max_distance_m == 0.0 || found.distance_m <= settings.max_distance_m;
}

// Bins end with the larger angle, so that kRightHandDeg ends one.
std::size_t BinOf(double rotation_error_deg) noexcept {
  const double bin = std::ceil(rotation_error_deg / kHandBinDeg) - 1.0;
  return std::min(static_cast<std::size_t>(std::max(bin, 0.0)), kNumBins - 1);
}

AnswerCounts NoAnswers(const std::vector<std::string>& classes) {
  AnswerCounts answers{.row_title = "object", .rows = classes, .counts = {}};
  std::vector<bool> is_right;
  for (std::size_t bin = 0; bin < kNumBins; ++bin) {
    const double high_deg = kHandBinDeg * static_cast<double>(bin + 1);
    answers.columns.push_back(fmt::format("to {}°", high_deg));
    is_right.push_back(high_deg <= kRightHandDeg);
  }
  answers.columns.emplace_back("too far");
  is_right.push_back(false);
  answers.counts.assign(classes.size(), std::vector<std::size_t>(kNumBins + 1));
  answers.is_right.assign(classes.size(), is_right);
  return answers;
}

GroupErrors ErrorsOf(std::string name,
                     const std::vector<HeldOut>& found,
                     const GraspSettings& settings) {
  GroupErrors errors{.name = std::move(name), .num_asked = found.size()};
  std::vector<double> positions_m;
  std::vector<double> rotations_deg;
  for (const HeldOut& one : found) {
    if (!IsKept(one, settings)) continue;
    positions_m.push_back(one.position_error_m);
    rotations_deg.push_back(one.rotation_error_deg);
  }
  errors.num_kept = positions_m.size();
  errors.median_position_m = Quantile(positions_m, 0.5);
  errors.high_position_m = Quantile(positions_m, kHighShare);
  errors.median_rotation_deg = Quantile(rotations_deg, 0.5);
  errors.high_rotation_deg = Quantile(rotations_deg, kHighShare);
  return errors;
}

}  // namespace

ViewCellResult FindHeldOut(const ViewCell& cell, const TrainingSet& shown, int num_threads) {
  const GraspSettings& settings = cell.settings.grasps;
  std::vector<HeldOut> found(shown.poses.size());
  ParallelFor(
      found.size(), num_threads, [&](std::size_t i) { found[i] = Find(shown, i, settings); });
  ViewCellResult result{.id = cell.id, .answers = NoAnswers(shown.classes)};
  std::vector<std::vector<HeldOut>> by_class(shown.classes.size());
  std::vector<JudgedAnswer> judged;
  std::vector<double> times_ms;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::size_t row = shown.poses[i].object_class;
    const bool is_kept = IsKept(found[i], settings);
    ++result.answers.counts[row][is_kept ? BinOf(found[i].rotation_error_deg) : kNumBins];
    by_class[row].push_back(found[i]);
    judged.push_back({.doubt = found[i].distance_m, .is_right = IsRight(found[i])});
    times_ms.push_back(found[i].time_ms);
  }
  for (std::size_t row = 0; row < shown.classes.size(); ++row) {
    result.groups.push_back(ShareOfRow(result.answers, row));
    result.errors.push_back(ErrorsOf(shown.classes[row], by_class[row], settings));
  }
  result.groups.push_back(ShareOfAll("all", result.groups));
  result.errors.push_back(ErrorsOf("all", found, settings));
  result.rejection = RejectionCurve(std::move(judged));
  result.times.push_back({"nearest_demonstration_ms", Quantile(std::move(times_ms), 0.5)});
  return result;
}

}  // namespace handcraft::experiments
