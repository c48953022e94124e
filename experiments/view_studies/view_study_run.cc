// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_run.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "datasets/formats/demonstration_set.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/evaluation/report_table.h"
#include "experiments/grasp_planning/grasp_library_input.h"
#include "experiments/runner/pinned_inputs.h"
#include "experiments/view_studies/class_cell.h"
#include "experiments/view_studies/demonstration_cell.h"
#include "experiments/view_studies/error_report.h"
#include "experiments/view_studies/plan_cell.h"
#include "experiments/view_studies/rotation_cell.h"
#include "experiments/view_studies/view_data.h"
#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"
#include "lib/robot/robot_file.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

std::string ResultsCsv(const std::vector<ViewCellResult>& results) {
  ReportTable table{
      .head = {"cell", "class", "num_views", "num_right", "share", "share_low", "share_high"}};
  for (const ViewCellResult& result : results) {
    for (const GroupShare& group : result.groups) {
      table.rows.push_back({result.id,
                            group.name,
                            NumberToText(group.num_views),
                            NumberToText(group.num_right),
                            NumberToText(group.share.value),
                            NumberToText(group.share.low),
                            NumberToText(group.share.high)});
    }
  }
  return CsvText(table);
}

std::string AnswersCsv(const std::vector<ViewCellResult>& results) {
  ReportTable table{.head = {"cell", "truth", "answer", "count", "right"}};
  for (const ViewCellResult& result : results) {
    const AnswerCounts& answers = result.answers;
    for (std::size_t row = 0; row < answers.rows.size(); ++row) {
      for (std::size_t column = 0; column < answers.columns.size(); ++column) {
        if (answers.counts[row][column] == 0) continue;
        table.rows.push_back({result.id,
                              answers.rows[row],
                              answers.columns[column],
                              NumberToText(answers.counts[row][column]),
                              answers.is_right[row][column] ? "1" : "0"});
      }
    }
  }
  return CsvText(table);
}

std::string TimesCsv(const std::vector<ViewCellResult>& results) {
  ReportTable table{.head = {"cell", "what", "value"}};
  for (const ViewCellResult& result : results) {
    for (const TimeFigure& time : result.times) {
      table.rows.push_back({result.id, time.name, NumberToText(time.value)});
    }
  }
  return CsvText(table);
}

// The groups that the study names, beside those of the cell.
void AddGroups(const ViewStudy& study, ViewCellResult& result) {
  for (const auto& [name, classes] : study.groups) {
    std::vector<GroupShare> parts;
    for (const std::string& object_class : classes) {
      const auto found = std::find_if(result.groups.begin(),
                                      result.groups.end(),
                                      [&](const GroupShare& g) { return g.name == object_class; });
      if (found == result.groups.end()) {
        throw Error({.kind = Error::Kind::kUsage,
                     .reason = fmt::format("groups.{}: \"{}\" is none of the objects that are "
                                           "asked about",
                                           name,
                                           object_class)});
      }
      parts.push_back(*found);
    }
    result.groups.push_back(ShareOfAll(name, parts));
  }
}

std::vector<ViewCellResult> WorkOutCells(const ViewStudyRun& run,
                                         const fs::path& demonstrations,
                                         const ViewStudyRunOptions& options) {
  const datasets::ViewSet* const test = run.test ? &*run.test : nullptr;
  grasp_library::TrainingSet shown;
  if (!demonstrations.empty()) {
    shown = DescribeInput(
        ReadGraspLibraryInput(run.train, demonstrations), options.num_threads, options.progress);
  }
  const auto work_out = [&](const ViewCell& cell) {
    switch (run.study.task) {
      case ViewTask::kObjectClass:
        return TellClasses(run.study, cell, run.train, test, options.num_threads, options.progress);
      case ViewTask::kObjectRotation:
        return FindRotations(cell, run.train, test, options.num_threads);
      case ViewTask::kNearestDemonstration:
        return FindHeldOut(cell, shown, options.num_threads);
      case ViewTask::kGraspPlan:
      case ViewTask::kGraspSuccess:
        return PlanGrasps(run.study,
                          cell,
                          {run.train, shown, test == nullptr ? run.train : *test},
                          options.out / "models" / cell.id,
                          options.progress);
    }
    return ViewCellResult{};
  };
  std::vector<ViewCellResult> results;
  for (const ViewCell& cell : run.cells) {
    Report(options.progress, "cells", results.size(), run.cells.size());
    results.push_back(work_out(cell));
    AddGroups(run.study, results.back());
  }
  Report(options.progress, "cells", run.cells.size(), run.cells.size());
  return results;
}

// The folder of the demonstration set, which is made where it is not there; empty: none is asked
// for.
fs::path DemonstrationsOf(const ViewStudyRun& run, const ViewStudyRunOptions& options) {
  if (run.study.task == ViewTask::kNearestDemonstration) return run.train.root;
  if (!run.study.demonstrations) return {};
  return ProvideViews(*run.study.demonstrations,
                      options.out / "demonstrations",
                      options.num_threads,
                      options.progress)
      .root;
}

// Files that plans need are looked at before sets are made, which takes minutes.
void RequireFilesOfPlans(const ViewStudyRun& run) {
  if (!IsOfPlans(run.study.task)) return;
  for (const ViewCell& cell : run.cells) {
    const GraspSettings& grasps = cell.settings.grasps;
    static_cast<void>(robot::ReadRobotFile(grasps.robot));
    if (!grasps.grasp_points.empty()) static_cast<void>(LoadModel(grasps.grasp_points));
  }
}

}  // namespace

ViewStudyRun RunViewStudy(const ViewStudy& study, const ViewStudyRunOptions& options) {
  RequireOption(options.num_threads >= 1, "num_threads", options.num_threads, "at least 1");
  ViewStudyRun run{.study = study, .cells = MakeViewCells(study)};
  RequireFilesOfPlans(run);
  const PinnedInputs inputs(options.out);
  inputs.Pin("version", fmt::format("{}\n", hc_version()));
  inputs.Pin("study", fmt::format("{}\n", fmt::join(CanonicalLines(study), "\n")));
  run.train =
      ProvideViews(study.train, options.out / "train", options.num_threads, options.progress);
  inputs.Pin("data.train", datasets::Fingerprint(run.train) + "\n");
  const fs::path demonstrations = DemonstrationsOf(run, options);
  if (!demonstrations.empty()) {
    const datasets::DemonstrationSet shown = datasets::ReadDemonstrationSet(demonstrations);
    inputs.Pin("data.demonstrations", datasets::Fingerprint(shown) + "\n");
  }
  if (study.test) {
    run.test =
        ProvideViews(*study.test, options.out / "test", options.num_threads, options.progress);
    inputs.Pin("data.test", datasets::Fingerprint(*run.test) + "\n");
  }
  run.results = WorkOutCells(run, demonstrations, options);
  WriteFileAtomically(options.out / "results.csv", ResultsCsv(run.results));
  WriteFileAtomically(options.out / "answers.csv", AnswersCsv(run.results));
  WriteFileAtomically(options.out / "times.csv", TimesCsv(run.results));
  for (const auto& [name, table] : {std::pair{"errors.csv", AllErrors(run.results)},
                                    std::pair{"rejection.csv", AllRejectionPoints(run.results)}}) {
    if (!table.rows.empty()) WriteFileAtomically(options.out / name, CsvText(table));
  }
  return run;
}

}  // namespace handcraft::experiments
