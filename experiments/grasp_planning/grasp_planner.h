// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "datasets/formats/organised_cloud.h"
#include "datasets/object_clouds.h"
#include "experiments/evaluation/cloud_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/grasp_planning/grasp_plan_options.h"
#include "lib/core/image.h"
#include "lib/features/grasp_search.h"
#include "lib/perception/cloud_view.h"
#include "lib/robot/inverse_kinematics.h"

namespace handcraft::experiments {

/// What the robot sees: a picture, its cloud and which pixels are the object (not 0); and what it
/// is told about this one, in place of what the planner's options say.
struct GraspScene {
  Image image;
  datasets::OrganisedCloud cloud;
  Image object_mask;
  std::optional<std::array<int, 2>> grasp_pixel = {};  ///< (u, v) of a click
  std::string object_class = {};                       ///< empty: not told
};

/// The pixels of what stands on the table, by search-space reduction: no table, all measured
/// pixels. Throws Error(kNoResult) when none is left.
[[nodiscard]] Image MaskAboveTable(const datasets::OrganisedCloud& cloud);

/// A layer and what it took, by the steady clock.
struct PlanStage {
  std::string_view name;
  double time_ms = 0.0;
};

struct GraspPlan {
  int u_px = 0;  ///< of p_g
  int v_px = 0;
  std::optional<double> probability = {};  ///< of the grasp point; none: it was told
  features::Vector3 point_m = {};          ///< p_g
  std::string object_class = {};
  std::optional<double> class_margin = {};  ///< of the classifier; none: the class was told
  /// The classifier takes it for none of its classes, and the nearest one was to be planned for.
  bool is_class_rejected = false;
  features::FoundGrasp grasp = {};
  /// Nearer demonstrations than the grasp's, whose poses the arm does not reach.
  std::size_t rank = 0;
  std::size_t num_attempts = 0;  ///< demonstrations whose poses the arm was asked for
  std::optional<double> rejection_distance_m = {};  ///< of the library
  robot::Pose base_from_grasp = {};                 ///< the hand's grasp centre
  robot::Pose base_from_tip = {};                   ///< the arm's tip
  robot::InverseKinematicsResult kinematics = {};
  std::vector<PlanStage> stages = {};

  /// The nearest demonstration is farther than the library allows.
  [[nodiscard]] bool IsRejected() const noexcept {
    return rejection_distance_m && !(grasp.distance_m <= *rejection_distance_m);
  }
};

/// plan.base_from_grasp, as the code of made-up objects takes poses.
[[nodiscard]] Eigen::Isometry3f BaseFromGrasp(const GraspPlan& plan);

/// Grasp planning, layer after layer (dissertation, chapter 4): p_g, the class, the turn about z,
/// the nearest demonstration, joint values. Where the arm does not reach the nearest one, the next
/// nearest are tried; where it reaches none of them, the one that it comes nearest to is told.
/// Models and arm are loaded once.
class GraspPlanner {
 public:
  /// Throws Error: options that break their rules, files that cannot be loaded, a model of another
  /// kind, a class (of the classifier any) that the library does not know, a library whose robot or
  /// joints are not the arm's.
  explicit GraspPlanner(const GraspPlanOptions& options);

  /// Plans for what is seen. Rejected and unreachable grasps are results. Throws
  /// Error(kBadInput) for pictures, clouds and masks of different sizes and a grasp point outside
  /// the picture; Error(kNoResult) when too little of the object was measured, for a cloud that no
  /// one plane fits, when there is no measured point to grasp at, and for an object that is none of
  /// the classes unless the nearest one will do.
  [[nodiscard]] GraspPlan Plan(const GraspScene& scene);

  [[nodiscard]] const robot::SerialChain& chain() const noexcept { return solver_->chain(); }
  /// The margin below which the object is none of the classes; −∞: it is always one.
  [[nodiscard]] double LeastClassMargin() const noexcept {
    return RejectionThreshold(classes_.get());
  }
  [[nodiscard]] std::string_view Method() const noexcept { return solver_->Method(); }

 private:
  void LoadClasses();
  void RequireSameArm(const std::string& robot_name) const;
  [[nodiscard]] std::size_t ClassNumber(const std::string& name) const;
  void TellClass(const GraspScene& scene, GraspPlan& plan);
  void FindPoint(const GraspScene& scene, GraspPlan& plan) const;
  void TakeBestPixel(const GraspScene& scene, GraspPlan& plan) const;
  void RankGrasps(const features::ShownClass& shown,
                  double object_angle_rad,
                  const features::Vector3& mean_m,
                  const GraspPlan& plan);
  void SetGrasp(std::size_t rank, GraspPlan& plan) const;
  void Reach(GraspPlan& plan) const;
  void ComeNearest(GraspPlan& plan) const;

  GraspPlanOptions options_;
  LoadedModel library_;
  LoadedModel grasp_points_;
  LoadedModel classes_;  ///< none: the class is told
  datasets::ObjectCloudOptions cloud_options_ = {};
  std::optional<CloudClassifier> classifier_ = {};
  std::unique_ptr<robot::InverseKinematics> solver_;
  robot::Pose tip_from_grasp_;
  std::vector<features::FoundGrasp> grasps_;  ///< that may be tried, nearest first
  std::vector<float> scratch_;
};

}  // namespace handcraft::experiments
