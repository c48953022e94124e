// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/plan_cell.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <map>
#include <optional>
#include <utility>

#include "datasets/view_folds.h"
#include "experiments/grasp_planning/grasp_planner.h"
#include "experiments/metrics/quantile.h"
#include "experiments/object_classes/object_class_training.h"
#include "experiments/view_studies/plan_judges.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/model_io/grasp_library_models.h"
#include "lib/model_io/model_writer.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNoPlan = "no plan";

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
  options.position = settings.position;
  options.max_attempts = settings.max_attempts;
  return options;
}

// The middle of the picture, or of the object's pixels.
std::array<int, 2> ClickOn(const Image& mask, GraspClick click) {
  std::array<std::int64_t, 2> sum = {};
  std::int64_t count = 0;
  for (int v = 0; v < mask.height() && click == GraspClick::kObject; ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask.At(u, v) == 0) continue;
      sum[0] += u;
      sum[1] += v;
      ++count;
    }
  }
  if (count == 0) return {mask.width() / 2, mask.height() / 2};
  return {static_cast<int>(sum[0] / count), static_cast<int>(sum[1] / count)};
}

GraspScene SceneOf(const ViewStudy& study,
                   const GraspSettings& settings,
                   const datasets::ViewSet& views,
                   std::size_t number) {
  datasets::LoadedView view = datasets::ReadView(views, number);
  const datasets::ObjectView& item = views.items[number];
  if (!view.cloud) {
    throw Error({.path = (views.root / item.image).string(), .reason = "the view has no cloud"});
  }
  GraspScene scene{.image = std::move(view.image),
                   .cloud = std::move(*view.cloud),
                   .object_mask = std::move(view.object_mask)};
  if (settings.grasp_points.empty()) {
    scene.grasp_pixel = ClickOn(scene.object_mask, settings.click);
  }
  if (settings.is_class_told) scene.object_class = RightClasses(study, item.object_class).front();
  return scene;
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

// None where the view does not allow of a plan.
std::optional<GraspPlan> TimedPlan(GraspPlanner& planner,
                                   const GraspScene& scene,
                                   double table_search_ms,
                                   PlanTimes& times) {
  const std::clock_t start = std::clock();
  GraspPlan plan;
  try {
    plan = planner.Plan(scene);
  } catch (const Error& error) {
    if (error.details().kind != Error::Kind::kNoResult) throw;
    return std::nullopt;
  }
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

AnswerCounts NoAnswers(const std::vector<std::string>& classes, const PlanJudge& judge) {
  AnswerCounts answers{
      .row_title = "object", .rows = classes, .columns = judge.outcomes, .counts = {}};
  answers.columns.emplace_back(kNoPlan);
  std::vector<bool> is_right = judge.is_right;
  is_right.push_back(false);
  answers.counts.assign(classes.size(), std::vector<std::size_t>(answers.columns.size()));
  answers.is_right.assign(classes.size(), is_right);
  return answers;
}

PlanJudge JudgeOf(const ViewStudy& study, const datasets::ViewSet& views) {
  return study.task == ViewTask::kGraspPlan ? JudgeByJointValues(study, views)
                                            : JudgeByTrueShape(views);
}

}  // namespace

ViewCellResult PlanGrasps(const ViewStudy& study,
                          const ViewCell& cell,
                          const PlanData& data,
                          const fs::path& models,
                          const Progress& progress) {
  fs::create_directories(models);
  GraspPlanOptions options = PlanOptions(cell, models);
  WriteClassifier(cell, data.train, options.object_class_model);
  WriteLibrary(cell, data.shown, options.grasp_library);
  const bool has_model = !options.grasp_point_model.empty();
  if (!has_model) options.grasp_pixel = {0, 0};  // each scene tells its own
  GraspPlanner planner(options);
  const PlanJudge judge = JudgeOf(study, data.asked);
  const datasets::ViewClasses classes = datasets::ClassesOf(data.asked);
  ViewCellResult result{.id = cell.id, .answers = NoAnswers(classes.names, judge)};
  PlanTimes times;
  for (std::size_t i = 0; i < data.asked.items.size(); ++i) {
    Report(progress, "planning", i, data.asked.items.size());
    const GraspScene scene = SceneOf(study, cell.settings.grasps, data.asked, i);
    const std::optional<GraspPlan> plan =
        TimedPlan(planner, scene, has_model ? TableSearchMs(scene) : 0.0, times);
    const std::size_t outcome = plan ? judge.outcome_of(i, *plan) : judge.outcomes.size();
    ++result.answers.counts[classes.values[i]][outcome];
  }
  result.times = times.Medians();
  for (std::size_t row = 0; row < classes.names.size(); ++row) {
    result.groups.push_back(ShareOfRow(result.answers, row));
  }
  result.groups.push_back(ShareOfAll("all", result.groups));
  return result;
}

}  // namespace handcraft::experiments
