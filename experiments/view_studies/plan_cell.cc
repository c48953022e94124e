// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/plan_cell.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <map>
#include <utility>

#include "experiments/grasp_planning/grasp_planner.h"
#include "experiments/metrics/quantile.h"
#include "experiments/object_classes/object_class_training.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/model_io/grasp_library_models.h"
#include "lib/model_io/model_writer.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

// What became of a plan, in the order of the columns.
enum class Outcome : std::uint8_t { kNearest, kNextNearest, kOutOfReach, kRejected, kOtherClass };
constexpr std::array kOutcomes = {
    "nearest reached", "next nearest reached", "out of reach", "too far", "other class"};

Outcome OutcomeOf(const GraspPlan& plan, const std::string& true_class) {
  if (plan.object_class != true_class) return Outcome::kOtherClass;
  if (plan.IsRejected()) return Outcome::kRejected;
  if (!plan.kinematics.IsSolved()) return Outcome::kOutOfReach;
  return plan.rank == 0 ? Outcome::kNearest : Outcome::kNextNearest;
}

void WriteClassifier(const ViewCell& cell, const datasets::ViewSet& views, const fs::path& path) {
  ObjectClassOptions options = cell.settings.classes;
  options.num_folds = 0;
  const ObjectClassTraining training = TrainObjectClasses(views, options);
  const datasets::MaskedCloud example = datasets::ReadObjectCloud(
      views, 0, {.frame = options.descriptor.frame, .outlier_step = options.outlier_step});
  WriteFileAtomically(path,
                      model_io::Serialise(model_io::MakeObjectClassModel(
                          training.model, example.View(), {.name = "object_class"})));
}

void WriteLibrary(const ViewCell& cell,
                  const grasp_library::TrainingSet& shown,
                  const fs::path& path) {
  const features::RotationRule& rule = cell.settings.rotation;
  const features::GraspLibrary library = grasp_library::TrainGraspLibrary(
      shown,
      {.compared_moments = rule.moments,
       .num_candidates = static_cast<int>(rule.num_candidates),
       .angle_weight = rule.angle_weight,
       .rejection_distance_m = cell.settings.grasps.max_distance_m});
  WriteFileAtomically(path,
                      model_io::Serialise(model_io::MakeGraspLibraryModel(
                          library, {.classes = shown.classes}, {.name = "grasp_library"})));
}

GraspPlanOptions PlanOptions(const ViewCell& cell, const fs::path& models) {
  const GraspSettings& settings = cell.settings.grasps;
  GraspPlanOptions options{.grasp_point_model = settings.grasp_points,
                           .object_class_model = models / "object_class.safetensors",
                           .grasp_library = models / "grasp_library.safetensors",
                           .num_neighbours = static_cast<int>(settings.num_neighbours),
                           .robot = settings.robot};
  options.max_attempts = settings.max_attempts;
  return options;
}

GraspScene SceneOf(const datasets::ViewSet& views, std::size_t number) {
  datasets::LoadedView view = datasets::ReadView(views, number);
  if (!view.cloud) {
    throw Error({.path = (views.root / views.items[number].image).string(),
                 .reason = "the view has no cloud"});
  }
  return {.image = std::move(view.image),
          .cloud = std::move(*view.cloud),
          .object_mask = std::move(view.object_mask)};
}

// Times of all plans by the name of what was done [ms], in the order in which it is done.
class PlanTimes {
 public:
  void Add(const std::string& name, double time_ms) {
    if (!values_.contains(name)) names_.push_back(name);
    values_[name].push_back(time_ms);
  }
  [[nodiscard]] std::vector<TimeFigure> Medians() const {
    std::vector<TimeFigure> figures;
    for (const std::string& name : names_) {
      figures.push_back({name, Quantile(values_.at(name), 0.5)});
      if (name == kAll) figures.push_back({"all_95_percent_ms", Quantile(values_.at(name), 0.95)});
    }
    return figures;
  }

  static constexpr const char* kAll = "all_ms";

 private:
  std::vector<std::string> names_;
  std::map<std::string, std::vector<double>> values_;
};

double MsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

// The search for what stands on the table: the mask that the plan uses is the set's.
double TableSearchMs(const GraspScene& scene) {
  const auto start = std::chrono::steady_clock::now();
  static_cast<void>(MaskAboveTable(scene.cloud));
  return MsSince(start);
}

GraspPlan TimedPlan(GraspPlanner& planner,
                    const GraspScene& scene,
                    double table_search_ms,
                    PlanTimes& times) {
  const std::clock_t start = std::clock();
  GraspPlan plan = planner.Plan(scene);
  const double processor_ms =
      1e3 * static_cast<double>(std::clock() - start) / static_cast<double>(CLOCKS_PER_SEC);
  plan.stages.front().time_ms += table_search_ms;
  double all_ms = 0.0;
  for (const PlanStage& stage : plan.stages) {
    std::string name(stage.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    times.Add(name + "_ms", stage.time_ms);
    all_ms += stage.time_ms;
  }
  times.Add(PlanTimes::kAll, all_ms);
  times.Add("plan_processor_ms", processor_ms);
  return plan;
}

AnswerCounts NoAnswers(const std::vector<std::string>& classes) {
  AnswerCounts answers{.row_title = "object", .rows = classes, .counts = {}};
  answers.columns.assign(kOutcomes.begin(), kOutcomes.end());
  answers.counts.assign(classes.size(), std::vector<std::size_t>(kOutcomes.size()));
  answers.is_right.assign(classes.size(), {true, true, false, false, false});
  return answers;
}

}  // namespace

ViewCellResult PlanGrasps(const ViewCell& cell,
                          const datasets::ViewSet& views,
                          const grasp_library::TrainingSet& shown,
                          const fs::path& models,
                          const Progress& progress) {
  fs::create_directories(models);
  GraspPlanOptions options = PlanOptions(cell, models);
  WriteClassifier(cell, views, options.object_class_model);
  WriteLibrary(cell, shown, options.grasp_library);
  const bool has_model = !options.grasp_point_model.empty();
  if (!has_model) {
    const Image first = datasets::ReadObjectMask(views, 0);
    options.grasp_pixel = {first.width() / 2, first.height() / 2};
  }
  GraspPlanner planner(options);
  ViewCellResult result{.id = cell.id, .answers = NoAnswers(shown.classes)};
  PlanTimes times;
  for (std::size_t i = 0; i < views.items.size(); ++i) {
    Report(progress, "planning", i, views.items.size());
    const GraspScene scene = SceneOf(views, i);
    const GraspPlan plan = TimedPlan(planner, scene, has_model ? TableSearchMs(scene) : 0.0, times);
    const std::string& true_class = views.items[i].object_class;
    const auto row = static_cast<std::size_t>(
        std::find(shown.classes.begin(), shown.classes.end(), true_class) - shown.classes.begin());
    ++result.answers.counts[row][static_cast<std::size_t>(OutcomeOf(plan, true_class))];
  }
  result.times = times.Medians();
  for (std::size_t row = 0; row < shown.classes.size(); ++row) {
    result.groups.push_back(ShareOfRow(result.answers, row));
  }
  result.groups.push_back(ShareOfAll("all", result.groups));
  return result;
}

}  // namespace handcraft::experiments
