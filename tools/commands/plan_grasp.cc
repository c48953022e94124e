// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "datasets/cloud_camera.h"
#include "datasets/demonstration_sheet.h"
#include "datasets/formats/mask_picture.h"
#include "experiments/evaluation/json_text.h"
#include "experiments/grasp_planning/grasp_planner.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "lib/perception/overlay.h"
#include "tools/commands.h"
#include "tools/common_options.h"
#include "tools/number_option.h"
#include "tools/output_folder.h"
#include "tools/robot_text.h"
#include "tools/text_table.h"

namespace handcraft::tools {
namespace {

using experiments::GraspPlan;
using experiments::GraspPlanner;
using experiments::GraspPlanOptions;
using experiments::GraspScene;
using Json = nlohmann::ordered_json;

struct PlanGraspOptions {
  std::string config;
  std::string image;
  std::string cloud;
  std::string mask;
  std::string object_class;
  std::string classifier;
  bool nearest_class = false;
  std::string library;
  std::string grasp_points;
  std::vector<double> grasp_pixel;
  std::string robot;
  int num_neighbours = 0;
  int max_attempts = 0;
  std::optional<double> max_attempt_distance_m = {};
  std::string out;
  bool json = false;
};

// What the plan file says, with what the command line says instead.
GraspPlanOptions Merge(const PlanGraspOptions& given) {
  GraspPlanOptions options;
  if (!given.config.empty()) options = experiments::ReadGraspPlanFile(given.config);
  if (!given.object_class.empty() || !given.classifier.empty()) {
    options.object_class = given.object_class;
    options.object_class_model = given.classifier;
  }
  if (given.nearest_class) options.take_nearest_class = true;
  if (!given.library.empty()) options.grasp_library = given.library;
  if (!given.robot.empty()) options.robot = given.robot;
  if (given.num_neighbours > 0) options.num_neighbours = given.num_neighbours;
  if (given.max_attempts > 0) options.max_attempts = given.max_attempts;
  if (given.max_attempt_distance_m) {
    options.max_attempt_distance_m = *given.max_attempt_distance_m;
  }
  if (!given.grasp_points.empty() || !given.grasp_pixel.empty()) {
    options.grasp_point_model = given.grasp_points;
    options.grasp_pixel.reset();
  }
  if (given.grasp_pixel.empty()) return options;
  if (given.grasp_pixel.size() != 2) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = fmt::format("--grasp-point: {} numbers given; column and row are due",
                                       given.grasp_pixel.size()),
                 .remedy = "give --grasp-point 320,240"});
  }
  options.grasp_pixel = {static_cast<int>(given.grasp_pixel[0]),
                         static_cast<int>(given.grasp_pixel[1])};
  return options;
}

GraspScene ReadScene(const PlanGraspOptions& options) {
  GraspScene scene{.image = perception::ReadImage(options.image),
                   .cloud = datasets::ReadPcd(options.cloud),
                   .object_mask = {}};
  scene.object_mask = options.mask.empty() ? experiments::MaskAboveTable(scene.cloud)
                                           : perception::ReadImage(options.mask);
  return scene;
}

Json StagesJson(const GraspPlan& plan) {
  Json stages = Json::array();
  for (const experiments::PlanStage& stage : plan.stages) {
    stages.push_back({{"stage", stage.name}, {"time_ms", stage.time_ms}});
  }
  return stages;
}

Json PlanJson(const GraspPlan& plan, const GraspPlanner& planner) {
  const robot::InverseKinematicsResult& found = plan.kinematics;
  Json json = {
      {"grasp_point", {{"u_px", plan.u_px}, {"v_px", plan.v_px}, {"position_m", plan.point_m}}},
      {"class", plan.object_class},
      {"object_angle_rad", plan.grasp.object_angle_rad},
      {"turn_rad", plan.grasp.turn_rad},
      {"view", plan.grasp.view},
      {"demonstration", plan.grasp.number},
      {"distance_m", plan.grasp.distance_m},
      {"rank", plan.rank},
      {"num_attempts", plan.num_attempts},
      {"rejected", plan.IsRejected()},
      {"base_from_grasp_centre", ToJson(plan.base_from_grasp)},
      {"base_from_tip", ToJson(plan.base_from_tip)},
      {"method", planner.Method()},
      {"solved", found.IsSolved()},
      {"num_solutions", found.size()},
      {"joints", JointsToJson(planner.chain(), found.best.joints)},
      {"position_error_m", found.best.error.position_m},
      {"rotation_error_rad", found.best.error.rotation_rad},
      {"stages", StagesJson(plan)}};
  if (plan.probability) json["grasp_point"]["probability"] = *plan.probability;
  if (plan.class_margin) json["class_margin"] = *plan.class_margin;
  if (std::isfinite(planner.LeastClassMargin())) {
    json["class_rejection_threshold"] = planner.LeastClassMargin();
  }
  json["class_rejected"] = plan.is_class_rejected;
  return json;
}

std::string RankText(std::size_t rank) {
  return rank == 0 ? "nearest" : fmt::format("{} nearer out of reach, next nearest", rank);
}

std::string PlanText(const GraspPlan& plan, const GraspPlanner& planner) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  TextTable stages({"stage", "time [ms]"});
  double sum_ms = 0.0;
  for (const experiments::PlanStage& stage : plan.stages) {
    stages.AddRow({std::string(stage.name), fmt::format("{:.3f}", stage.time_ms)});
    sum_ms += stage.time_ms;
  }
  stages.AddRow({"all", fmt::format("{:.3f}", sum_ms)});
  TextTable joints({"joint", "value"});
  for (std::size_t i = 0; i < planner.chain().size(); ++i) {
    joints.AddRow(
        {planner.chain().joints[i].name, fmt::format("{:.4f}", plan.kinematics.best.joints[i])});
  }
  return fmt::format(
             "{}{} turned by {:.0f} degrees, to be grasped at pixel {},{}\n"
             "{} demonstration {}, {:.1f} mm away, shown {:.0f} degrees further\n\n",
             plan.object_class,
             plan.is_class_rejected ? ", the nearest of the classes, though it is none of these,"
                                    : "",
             plan.grasp.object_angle_rad / kDegree,
             plan.u_px,
             plan.v_px,
             RankText(plan.rank),
             plan.grasp.number,
             1000.0 * plan.grasp.distance_m,
             plan.grasp.turn_rad / kDegree) +
         joints.ToText() + '\n' + stages.ToText();
}

// The grasp point at this pixel and a hand at the planned pose, on a picture of this camera.
Image Overlay(const Image& picture,
              const synthetic::PinholeCamera& camera,
              const GraspPlan& plan,
              const perception::MarkedPoint& mark) {
  Image drawn = perception::DrawGraspPoints(picture, {}, {&mark, 1});
  const auto& p = plan.base_from_grasp.translation_m;
  const auto q = robot::QuaternionFromRotation(plan.base_from_grasp.rotation);
  const datasets::EndEffectorPose pose{.position_m = {p[0], p[1], p[2]},
                                       .rotation = Eigen::Quaterniond(q[3], q[0], q[1], q[2])};
  constexpr int kLinesPerSide = 200;
  const int side_px = std::max(picture.width(), picture.height());
  datasets::DrawHands(
      drawn, camera, {&pose, 1}, datasets::Hand::kRight, std::max(2, side_px / kLinesPerSide));
  return drawn;
}

// The surroundings of the grasp point enlarged: about 0.24 m of them, into which a hand fits.
Image CloseUp(const GraspScene& scene,
              const synthetic::PinholeCamera& camera,
              const GraspPlan& plan) {
  constexpr float kHalfSideM = 0.06F;
  constexpr int kWidthPx = 640;
  const Eigen::Vector3f p_in_base(static_cast<float>(plan.point_m[0]),
                                  static_cast<float>(plan.point_m[1]),
                                  static_cast<float>(plan.point_m[2]));
  const float depth_m = (camera.base_from_camera.inverse() * p_in_base).z();
  const int half_px = std::max(1, static_cast<int>(camera.focal_px * kHalfSideM / depth_m));
  const datasets::PicturePart part = datasets::PartAbout(scene.image,
                                                         {.u_px = plan.u_px - half_px,
                                                          .v_px = plan.v_px - half_px,
                                                          .width = 2 * half_px,
                                                          .height = 2 * half_px},
                                                         camera,
                                                         kWidthPx);
  const Eigen::Vector2f pixel = part.camera.Project(p_in_base);
  return Overlay(part.picture,
                 part.camera,
                 plan,
                 {.u_px = static_cast<int>(std::lround(pixel.x())),
                  .v_px = static_cast<int>(std::lround(pixel.y())),
                  .probability = 1.0F});
}

// A plan that the robot must not carry out.
void RequireUsable(const GraspPlan& plan) {
  if (plan.IsRejected()) {
    throw Error(
        {.kind = Error::Kind::kNoResult,
         .reason = fmt::format("the nearest demonstration is {:.4g} m from the grasp point; "
                               "the library allows {:.4g} m",
                               plan.grasp.distance_m,
                               *plan.rejection_distance_m),
         .remedy = "grasp elsewhere, or show more poses"});
  }
  if (plan.kinematics.IsSolved()) return;
  throw Error({.kind = Error::Kind::kNoResult,
               .reason = fmt::format("no joint values within the limits reach the {} nearest "
                                     "demonstrated grasps; the best attempt is off by {:.4g} m "
                                     "and {:.4g} rad",
                                     plan.num_attempts,
                                     plan.kinematics.best.error.position_m,
                                     plan.kinematics.best.error.rotation_rad),
               .remedy = "grasp elsewhere, give more --attempts, or look at the place of the arm "
                         "and the hand's frame"});
}

void RunPlanGrasp(const PlanGraspOptions& options, const Console& console) {
  GraspPlanner planner(Merge(options));
  const GraspScene scene = ReadScene(options);
  const GraspPlan plan = planner.Plan(scene);
  if (!options.out.empty()) {
    OutputFolder folder(options.out);
    WriteFileAtomically(folder.Claim("plan.json"), experiments::JsonText(PlanJson(plan, planner)));
    const synthetic::PinholeCamera camera = datasets::FitCamera(scene.cloud);
    perception::WritePng(folder.Claim("overlay.png"),
                         Overlay(scene.image,
                                 camera,
                                 plan,
                                 {.u_px = plan.u_px, .v_px = plan.v_px, .probability = 1.0F}));
    perception::WritePng(folder.Claim("close_up.png"), CloseUp(scene, camera, plan));
    folder.Keep();
  }
  if (options.json) console.Print(PlanJson(plan, planner));
  RequireUsable(plan);
  if (!options.json) console.out << PlanText(plan, planner);
}

}  // namespace

void AddPlanGrasp(CLI::App& parent, const Console& console) {
  auto options = std::make_shared<PlanGraspOptions>();
  CLI::App* command = parent.add_subcommand(
      "grasp", "Joint values that bring the hand to an object, as it was shown for its class");
  command->add_option("--image", options->image, "Picture")->required();
  command->add_option("--cloud", options->cloud, "Its organised cloud (.pcd)")->required();
  command->add_option("--mask", options->mask, "Object mask; else what stands on the table");
  command->add_option("--config", options->config, "Plan file (TOML) that names the components");
  command->add_option("--classifier", options->classifier, "Model that tells the object's class");
  command->add_option("--class", options->object_class, "Class of the object, as told");
  command->add_flag("--nearest-class",
                    options->nearest_class,
                    "Plan for the nearest class when the object is none of the model's");
  command->add_option("--library", options->library, "Grasp library");
  AddNumberList(*command, "--grasp-point", options->grasp_pixel, "Where to grasp: column,row [px]");
  command->add_option("--grasp-points", options->grasp_points, "Model that finds where to grasp");
  command->add_option("--robot", options->robot, "Robot file of the arm");
  AddNumber(*command,
            "--neighbours",
            options->num_neighbours,
            IntegerWithin(1, 32),
            "Demonstrations to average [1]");
  AddNumber(*command,
            "--attempts",
            options->max_attempts,
            IntegerWithin(1, 64),
            "Demonstrations to try, nearest first, until the arm reaches one [16]");
  command
      ->add_option("--attempt-distance-m",
                   options->max_attempt_distance_m,
                   "Try none after the first that is farther from the grasp point; 0: any [0]")
      ->transform(CheckNumber<double>([](double distance_m) {
        return distance_m >= 0.0 && distance_m <= 1000.0 ? std::string() : "from 0 to 1000";
      }))
      ->type_name("NUMBER");
  command->add_option("--out", options->out, "Folder for plan.json, overlay.png and close_up.png");
  AddJsonFlag(*command, options->json);
  SetExample(*command,
             "handcraft plan grasp --config plan.toml --image image.png --cloud cloud.pcd "
             "--grasp-point 320,240");
  command->callback([options, &console] { RunPlanGrasp(*options, console); });
}

}  // namespace handcraft::tools
