// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/grasp_planning/grasp_library_input.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "datasets/described_views.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

using datasets::ObjectView;
using datasets::ViewSet;

double AngleOf(const ViewSet& set, const ObjectView& view) {
  if (view.angle_deg) return *view.angle_deg * std::numbers::pi / 180.0;
  throw Error({.path = (set.root / view.image).string(),
               .reason = "the view has no angle_deg",
               .remedy = "give views whose turn about z is known"});
}

std::vector<std::string> ClassesOf(const ViewSet& set) {
  std::vector<std::string> classes;
  for (const ObjectView& view : set.items) {
    if (std::find(classes.begin(), classes.end(), view.object_class) == classes.end()) {
      classes.push_back(view.object_class);
    }
  }
  return classes;
}

std::size_t ClassNumber(const std::vector<std::string>& classes, const std::string& name) {
  return static_cast<std::size_t>(std::find(classes.begin(), classes.end(), name) -
                                  classes.begin());
}

}  // namespace

GraspLibraryInput ReadGraspLibraryInput(ViewSet views,
                                        const std::filesystem::path& demonstrations) {
  GraspLibraryInput input{.views = std::move(views),
                          .shown_views = datasets::ReadViewSet(demonstrations),
                          .demonstrations = datasets::ReadDemonstrationSet(demonstrations)};
  for (const ObjectView& view : input.views.items) static_cast<void>(AngleOf(input.views, view));
  const std::vector<std::string> classes = ClassesOf(input.views);
  for (const datasets::Demonstration& shown : input.demonstrations.items) {
    if (ClassNumber(classes, shown.object_class) < classes.size()) continue;
    throw Error({.path = demonstrations.string(),
                 .reason = "poses are shown for class " + shown.object_class +
                           ", which has no view in " + input.views.root.string(),
                 .remedy = "give a view set of the same classes"});
  }
  return input;
}

grasp_library::TrainingSet DescribeInput(const GraspLibraryInput& input,
                                         int num_threads,
                                         const Progress& progress) {
  grasp_library::TrainingSet set{.classes = ClassesOf(input.views)};
  const auto seen = datasets::DescribeViews(input.views, num_threads, progress);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const ObjectView& view = input.views.items[i];
    set.views.push_back({.object_class = ClassNumber(set.classes, view.object_class),
                         .angle_rad = AngleOf(input.views, view),
                         .description = seen[i]});
  }
  std::map<std::string, std::pair<double, features::Vector3>> places;  // angle and p_m, by image
  const auto shown_views = datasets::DescribeViews(input.shown_views, num_threads, progress);
  for (std::size_t i = 0; i < shown_views.size(); ++i) {
    const ObjectView& view = input.shown_views.items[i];
    places[view.image] = {AngleOf(input.shown_views, view), shown_views[i].mean_m};
  }
  std::int32_t number = 0;
  for (const datasets::Demonstration& shown : input.demonstrations.items) {
    const auto& [angle_rad, mean_m] = places.at(shown.view);
    const Eigen::Vector3d& p = shown.pose.position_m;
    const Eigen::Quaterniond& q = shown.pose.rotation;
    set.poses.push_back({.object_class = ClassNumber(set.classes, shown.object_class),
                         .angle_rad = angle_rad,
                         .mean_m = mean_m,
                         .position_m = {p.x(), p.y(), p.z()},
                         .rotation = {q.x(), q.y(), q.z(), q.w()},
                         .number = number++});
  }
  return set;
}

}  // namespace handcraft::experiments
