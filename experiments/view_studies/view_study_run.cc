// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/evaluation/report_table.h"
#include "experiments/runner/pinned_inputs.h"
#include "experiments/view_studies/class_cell.h"
#include "experiments/view_studies/rotation_cell.h"
#include "experiments/view_studies/view_data.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"
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

std::vector<ViewCellResult> WorkOutCells(const ViewStudyRun& run,
                                         const ViewStudyRunOptions& options) {
  const datasets::ViewSet* const test = run.test ? &*run.test : nullptr;
  std::vector<ViewCellResult> results;
  for (const ViewCell& cell : run.cells) {
    Report(options.progress, "cells", results.size(), run.cells.size());
    results.push_back(
        run.study.task == ViewTask::kObjectClass
            ? TellClasses(run.study, cell, run.train, test, options.num_threads, options.progress)
            : FindRotations(cell, run.train, test, options.num_threads));
  }
  Report(options.progress, "cells", run.cells.size(), run.cells.size());
  return results;
}

}  // namespace

ViewStudyRun RunViewStudy(const ViewStudy& study, const ViewStudyRunOptions& options) {
  RequireOption(options.num_threads >= 1, "num_threads", options.num_threads, "at least 1");
  ViewStudyRun run{.study = study, .cells = MakeViewCells(study)};
  const PinnedInputs inputs(options.out);
  inputs.Pin("version", fmt::format("{}\n", hc_version()));
  inputs.Pin("study", fmt::format("{}\n", fmt::join(CanonicalLines(study), "\n")));
  run.train =
      ProvideViews(study.train, options.out / "train", options.num_threads, options.progress);
  inputs.Pin("data.train", datasets::Fingerprint(run.train) + "\n");
  if (study.test) {
    run.test =
        ProvideViews(*study.test, options.out / "test", options.num_threads, options.progress);
    inputs.Pin("data.test", datasets::Fingerprint(*run.test) + "\n");
  }
  run.results = WorkOutCells(run, options);
  WriteFileAtomically(options.out / "results.csv", ResultsCsv(run.results));
  WriteFileAtomically(options.out / "answers.csv", AnswersCsv(run.results));
  WriteFileAtomically(options.out / "times.csv", TimesCsv(run.results));
  return run;
}

}  // namespace handcraft::experiments
