// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/grasp_planning/grasp_planner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "experiments/evaluation/runtime_scoring.h"
#include "lib/core/error.h"
#include "lib/perception/search_region.h"
#include "lib/robot/nearest_attempt.h"
#include "lib/robot/robot_file.h"
#include "lib/runtime/model_handle.h"

namespace handcraft::experiments {
namespace {

using runtime::GraspLibraryModel;

class StageClock {
 public:
  explicit StageClock(std::vector<PlanStage>& stages) : stages_(stages) {}

  void Done(std::string_view name) {
    const auto now = std::chrono::steady_clock::now();
    stages_.push_back({name, std::chrono::duration<double, std::milli>(now - start_).count()});
    start_ = now;
  }

 private:
  std::vector<PlanStage>& stages_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

const GraspLibraryModel& LibraryOf(const LoadedModel& model) {
  return std::get<GraspLibraryModel>(model->predictor);
}

LoadedModel LoadKind(const std::filesystem::path& path, hc_kind kind) {
  LoadedModel model = LoadModel(path);
  const hc_kind found = hc_model_kind(model.get());
  if (found == kind) return model;
  throw Error(
      {.path = path.string(),
       .reason = fmt::format("a model of kind {}; {} is due", KindName(found), KindName(kind)),
       .remedy = "look at it with 'handcraft check-model', and at the plan file's tables"});
}

void RequireSizes(const GraspScene& scene) {
  const auto fits = [&scene](int width, int height) {
    return width == scene.cloud.width && height == scene.cloud.height;
  };
  if (fits(scene.image.width(), scene.image.height()) &&
      fits(scene.object_mask.width(), scene.object_mask.height())) {
    if (scene.object_mask.channels() == 1) return;
    throw Error(
        {.reason = fmt::format("the mask has {} channels; 1 is due", scene.object_mask.channels()),
         .remedy = "give a --mask in gray that is 0 where the object is not"});
  }
  throw Error(
      {.reason = fmt::format("the picture has {} × {} pixels, the mask {} × {} and the cloud "
                             "{} × {}; all must be the same",
                             scene.image.width(),
                             scene.image.height(),
                             scene.object_mask.width(),
                             scene.object_mask.height(),
                             scene.cloud.width,
                             scene.cloud.height),
       .remedy = "give files of one and the same view"});
}

features::ObjectCloud CloudOf(const GraspScene& scene) {
  return {.points = scene.cloud.points.data()->data(),
          .width = scene.cloud.width,
          .height = scene.cloud.height,
          .row_stride = std::ptrdiff_t{3} * scene.cloud.width,
          .mask = scene.object_mask.Row(0),
          .mask_stride = scene.object_mask.width()};
}

void SetPoint(const GraspScene& scene, int u_px, int v_px, GraspPlan& plan) {
  plan.u_px = u_px;
  plan.v_px = v_px;
  const Eigen::Vector3d p = scene.cloud.At(u_px, v_px).cast<double>();
  plan.point_m = {p.x(), p.y(), p.z()};
}

// The measured pixel of the object nearest to a click; none within reach: an error.
void TakePixel(const GraspScene& scene, const std::array<int, 2>& pixel, GraspPlan& plan) {
  constexpr int kReachPx = 15;
  const auto [u, v] = pixel;
  if (u >= scene.cloud.width || v >= scene.cloud.height || u < 0 || v < 0) {
    throw Error({.reason = fmt::format("the grasp point {},{} is outside the picture of {} × {}",
                                       u,
                                       v,
                                       scene.cloud.width,
                                       scene.cloud.height),
                 .remedy = "give --grasp-point column,row, counted from 0"});
  }
  int least = kReachPx * kReachPx + 1;
  for (int y = std::max(0, v - kReachPx); y <= std::min(scene.cloud.height - 1, v + kReachPx);
       ++y) {
    for (int x = std::max(0, u - kReachPx); x <= std::min(scene.cloud.width - 1, u + kReachPx);
         ++x) {
      const int squared = (x - u) * (x - u) + (y - v) * (y - v);
      if (squared >= least || scene.object_mask.At(x, y) == 0 ||
          !datasets::IsMeasured(scene.cloud.At(x, y))) {
        continue;
      }
      least = squared;
      SetPoint(scene, x, y, plan);
    }
  }
  if (least <= kReachPx * kReachPx) return;
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = fmt::format(
                   "no point of the object was measured within {} pixels of {},{}", kReachPx, u, v),
               .remedy = "click on the object"});
}

robot::Pose PoseOf(const features::Vector3& position_m, const features::Quaternion& rotation) {
  return {robot::RotationFromQuaternion(rotation), position_m};
}

// One rule for all layers: what was seen is too little, whatever the file's form.
[[noreturn]] void RefuseFewPoints() {
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = fmt::format("fewer than {} points of the object were measured",
                                     features::kMinObjectPoints),
               .remedy = "look at it from elsewhere, or give another --mask"});
}

// Said before a click is searched for, which could not help.
void RequireMeasured(const GraspScene& scene) {
  bool has_object = false;
  std::size_t num_measured = 0;
  for (int v = 0; v < scene.cloud.height; ++v) {
    for (int u = 0; u < scene.cloud.width; ++u) {
      if (scene.object_mask.At(u, v) == 0) continue;
      has_object = true;
      num_measured += datasets::IsMeasured(scene.cloud.At(u, v)) ? 1 : 0;
      if (num_measured >= features::kMinObjectPoints) return;
    }
  }
  if (has_object) RefuseFewPoints();
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = "no pixel of the mask is the object's",
               .remedy = "give a --mask that is not 0 where the object is, or none"});
}

}  // namespace

Image MaskAboveTable(const datasets::OrganisedCloud& cloud) {
  const perception::TablePlanes table = perception::FindTable(cloud.View(), {});
  perception::PixelPoints points;
  const perception::TableRemovalOptions options;
  perception::TakePointsOffPlanes(cloud.View(), table.planes, options.epsilon_m, points);
  if (!points.empty()) perception::RemoveOutliers(points, {});
  if (points.empty()) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "nothing stands on the table in the cloud",
                 .remedy = "give --mask, the object's pixels"});
  }
  Image mask(cloud.width, cloud.height);
  for (const std::int32_t pixel : points.Pixels()) {
    mask.At(pixel % cloud.width, pixel / cloud.width) = 255;
  }
  return mask;
}

Eigen::Isometry3f BaseFromGrasp(const GraspPlan& plan) {
  using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const robot::Pose& pose = plan.base_from_grasp;
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.linear() = Eigen::Map<const RowMajor>(pose.rotation.data());
  isometry.translation() = Eigen::Map<const Eigen::Vector3d>(pose.translation_m.data());
  return isometry.cast<float>();
}

GraspPlanner::GraspPlanner(const GraspPlanOptions& options) : options_(options) {
  options.Validate();
  library_ = LoadKind(options.grasp_library, HC_KIND_GRASP_LIBRARY);
  if (!options.grasp_point_model.empty()) {
    grasp_points_ = LoadKind(options.grasp_point_model, HC_KIND_GRASP_POINT);
  }
  LoadClasses();
  const robot::RobotArm arm = robot::ReadRobotFile(options.robot);
  solver_ = robot::MakeInverseKinematics(arm.chain);
  if (!options.any_arm) RequireSameArm(arm.robot);
  if (!options.reference_joints.empty()) {
    arm.chain.RequireWithinLimits(options.reference_joints);
  }
  tip_from_grasp_ = PoseOf(options.grasp_centre_m, options.grasp_centre_xyzw);
}

void GraspPlanner::LoadClasses() {
  if (options_.object_class_model.empty()) {
    static_cast<void>(ClassNumber(options_.object_class));
    return;
  }
  classes_ = LoadKind(options_.object_class_model, HC_KIND_OBJECT_CLASS);
  for (std::size_t i = 0; i < hc_model_num_classes(classes_.get()); ++i) {
    static_cast<void>(ClassNumber(hc_model_class_name(classes_.get(), i)));
  }
  cloud_options_ = ReadCloudOptions(options_.object_class_model);
  classifier_.emplace(classes_.get());
}

void GraspPlanner::TellClass(const GraspScene& scene, GraspPlan& plan) {
  const bool is_told = !scene.object_class.empty();
  plan.object_class = is_told ? scene.object_class : options_.object_class;
  if (is_told || !classifier_) return;
  datasets::MaskedCloud object = datasets::CropToMask(scene.cloud, scene.object_mask);
  const CloudClass found = classifier_->Classify(
      datasets::TakeObjectCloud(std::move(object.cloud), std::move(object.mask), cloud_options_));
  if (!found.has_points) RefuseFewPoints();
  plan.object_class = hc_model_class_name(classes_.get(), found.number);
  plan.class_margin = found.margin;
  plan.is_class_rejected = found.is_rejected;
  if (!found.is_rejected || options_.take_nearest_class) return;
  throw Error(
      {.kind = Error::Kind::kNoResult,
       .path = options_.object_class_model.string(),
       .reason = fmt::format("the object is none of the model's classes: the nearest is '{}', with "
                             "a margin of {:.4g}, and the model asks for {:.4g}",
                             plan.object_class,
                             found.margin,
                             RejectionThreshold(classes_.get())),
       .remedy = "tell its class with --class, plan for the nearest with --nearest-class "
                 "(none_of_these = \"nearest\" in [object_class] of the plan file), or train it"});
}

void GraspPlanner::RequireSameArm(const std::string& robot_name) const {
  const std::string shown_by = MetadataOf(library_.get(), "hc.robot");
  const std::string shown_joints = MetadataOf(library_.get(), "hc.joint_names");
  std::string joints;
  for (const robot::Joint& joint : chain().joints) {
    joints.append(joints.empty() ? "" : " ").append(joint.name);
  }
  const bool other_robot = !shown_by.empty() && shown_by != robot_name;
  if (!other_robot && (shown_joints.empty() || shown_joints == joints)) return;
  throw Error(
      {.path = options_.robot.string(),
       .reason =
           other_robot
               ? fmt::format("robot {}; the grasps were shown by robot {}", robot_name, shown_by)
               : fmt::format("joints {}; the grasps were shown by joints {}", joints, shown_joints),
       .remedy = "give the robot file of that arm, or plan for another with any_arm = true in "
                 "[robot] of the plan file (--config)"});
}

std::size_t GraspPlanner::ClassNumber(const std::string& name) const {
  const std::vector<std::string>& names = LibraryOf(library_).class_names;
  std::string known;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return i;
    known.append(i == 0 ? "" : ", ").append(names[i]);
  }
  throw Error({.path = options_.grasp_library.string(),
               .reason = "the grasp library knows no class '" + name + "'",
               .remedy = "there are: " + known});
}

void GraspPlanner::TakeBestPixel(const GraspScene& scene, GraspPlan& plan) const {
  Image wanted = scene.object_mask;
  for (int v = 0; v < wanted.height(); ++v) {
    for (int u = 0; u < wanted.width(); ++u) {
      if (!datasets::IsMeasured(scene.cloud.At(u, v))) wanted.At(u, v) = 0;
    }
  }
  const RuntimeScores scores =
      ScoreWithRuntime(grasp_points_.get(), scene.image, "the picture", &wanted);
  const std::vector<hc_point> best = FindBestPixels(scores.probabilities, 1, 0.0, 0);
  if (best.empty()) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "no measured pixel of the object is a grasp point",
                 .remedy = "give --grasp-point u,v"});
  }
  SetPoint(scene, best[0].u, best[0].v, plan);
  plan.probability = static_cast<double>(best[0].probability);
}

void GraspPlanner::FindPoint(const GraspScene& scene, GraspPlan& plan) const {
  const auto& pixel = scene.grasp_pixel ? scene.grasp_pixel : options_.grasp_pixel;
  if (pixel) {
    TakePixel(scene, *pixel, plan);
  } else {
    TakeBestPixel(scene, plan);
  }
}

// The grasps that may be tried: of those after the first only the ones near enough.
void GraspPlanner::RankGrasps(const features::ShownClass& shown,
                              double object_angle_rad,
                              const features::Vector3& mean_m,
                              const GraspPlan& plan) {
  constexpr double kAny = std::numeric_limits<double>::infinity();
  const double wanted_m = options_.max_attempt_distance_m;
  const double farthest_m =
      std::min(wanted_m > 0.0 ? wanted_m : kAny, plan.rejection_distance_m.value_or(kAny));
  grasps_.resize(static_cast<std::size_t>(options_.max_attempts));
  grasps_.resize(
      features::RankGraspsAt(shown,
                             object_angle_rad,
                             mean_m,
                             {.point_m = plan.point_m,
                              .num_neighbours = static_cast<std::size_t>(options_.num_neighbours)},
                             grasps_));
  while (grasps_.size() > 1 && grasps_.back().distance_m > farthest_m) grasps_.pop_back();
}

void GraspPlanner::SetGrasp(std::size_t rank, GraspPlan& plan) const {
  plan.rank = rank;
  plan.grasp = grasps_[rank];
  plan.base_from_grasp =
      PoseOf(options_.position == GraspPosition::kGraspPoint ? plan.point_m : plan.grasp.position_m,
             plan.grasp.rotation);
  plan.base_from_tip = plan.base_from_grasp * robot::Inverse(tip_from_grasp_);
}

void GraspPlanner::Reach(GraspPlan& plan) const {
  for (std::size_t rank = 0; rank < grasps_.size(); ++rank) {
    SetGrasp(rank, plan);
    plan.num_attempts = rank + 1;
    solver_->FindSolutions(plan.base_from_tip, options_.reference_joints, plan.kinematics);
    if (plan.kinematics.IsSolved()) return;
  }
  ComeNearest(plan);
}

// Of grasps that are all out of reach the one whose nearest attempt is off least.
void GraspPlanner::ComeNearest(GraspPlan& plan) const {
  std::size_t nearest = 0;
  double least_m2 = std::numeric_limits<double>::infinity();
  robot::InverseKinematicsResult attempt;
  for (std::size_t rank = 0; rank < grasps_.size() && !plan.kinematics.IsSolved(); ++rank) {
    SetGrasp(rank, plan);
    solver_->Solve(plan.base_from_tip, options_.reference_joints, attempt);
    const double error_m2 = robot::SquaredError(attempt.best.error);
    if (!attempt.IsSolved() && error_m2 >= least_m2) continue;
    least_m2 = error_m2;
    nearest = rank;
    std::swap(plan.kinematics, attempt);
  }
  SetGrasp(nearest, plan);
}

GraspPlan GraspPlanner::Plan(const GraspScene& scene) {
  RequireSizes(scene);
  RequireMeasured(scene);
  const features::ObjectCloud cloud = CloudOf(scene);
  scratch_.resize(features::ObjectPlaneScratch(cloud.width, cloud.height));
  const GraspLibraryModel& library = LibraryOf(library_);
  GraspPlan plan;
  plan.rejection_distance_m = library.library.rejection_distance_m;
  StageClock clock(plan.stages);
  FindPoint(scene, plan);
  clock.Done("grasp point");
  TellClass(scene, plan);
  const features::ShownClass shown = library.library.Class(ClassNumber(plan.object_class));
  clock.Done("object class");
  features::ViewDescription view;
  const features::CloudFault fault = features::DescribeView(cloud, scratch_, view);
  if (fault != features::CloudFault::kNone) {
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "the object's cloud " + std::string(features::NameOf(fault)),
                 .remedy = "look at it from elsewhere, or give another --mask"});
  }
  const std::size_t nearest = features::NearestView(view, shown.views, library.library.rule);
  clock.Done("object rotation");
  RankGrasps(shown, shown.view_angles_rad[nearest], view.mean_m, plan);
  clock.Done("nearest demonstration");
  Reach(plan);
  plan.grasp.view = nearest;
  clock.Done("inverse kinematics");
  return plan;
}

}  // namespace handcraft::experiments
