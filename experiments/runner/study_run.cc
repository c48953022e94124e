// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_run.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "datasets/parallel_reporting.h"
#include "experiments/evaluation/loaded_model.h"
#include "experiments/runner/cell_training.h"
#include "experiments/runner/object_region.h"
#include "experiments/runner/pinned_inputs.h"
#include "experiments/runner/results_csv.h"
#include "lib/core/file.h"
#include "lib/core/option_rules.h"
#include "lib/core/path_kind.h"
#include "lib/core/sha256.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kResultEnding = ".json";
constexpr const char* kModelEnding = ".safetensors";

CellResult WorkOut(const Study& study,
                   const StudyData& data,
                   const Cell& cell,
                   const fs::path& model_file,
                   int num_threads) {
  const CellData divided = DivideForCell(study, data, cell);
  const CellTraining training =
      TrainCell(divided.train, cell.settings, study.split, cell.seed, num_threads);
  WriteFileAtomically(model_file, training.model);
  const LoadedModel model = LoadModel(training.model);
  EvaluationOptions options{
      .pixels_per_image = study.pixels_per_image,
      .bootstrap_resamples = study.bootstrap_resamples,
      .seed = study.seed,
      .num_threads = num_threads,
      .data_fingerprint = data.test ? data.test_fingerprint : data.train_fingerprint};
  if (cell.settings.region == TestRegion::kObject) {
    options.region = [&divided](std::size_t item, const Image& picture) {
      return FindObjectRegion(divided.test, item, picture);
    };
  }
  const GraspPointEvaluation evaluation = EvaluateGraspPoints(model.get(), divided.test, options);
  CellResult result = MakeCellResult(cell.id, training, evaluation, divided.test);
  result.model_sha256 = Sha256Hex(training.model);
  return result;
}

// Before anything is made, and again when the pictures are there.
void PinStudy(const PinnedInputs& inputs, const Study& study) {
  inputs.Pin("version", fmt::format("{}\n", hc_version()));
  inputs.Pin("study", fmt::format("{}\n", fmt::join(CanonicalLines(study), "\n")));
}

void PinData(const PinnedInputs& inputs, const StudyData& data) {
  inputs.Pin("data.train", data.train_fingerprint + "\n");
  if (data.test) inputs.Pin("data.test", data.test_fingerprint + "\n");
}

bool LooksOnTheObject(const std::vector<Cell>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const Cell& cell) {
    return cell.settings.region == TestRegion::kObject;
  });
}

// Before anything is written or made. Made pictures have depth.
void RequireFolders(const Study& study, const std::vector<Cell>& cells) {
  if (!study.train.folder.empty()) {
    static_cast<void>(datasets::ReadLabelledImageSet(study.train.folder));
  }
  const DataSource& tested = study.test ? *study.test : study.train;
  if (tested.folder.empty()) return;
  const datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(tested.folder);
  if (LooksOnTheObject(cells)) RequireDepth(set);
}

// What a killed run has left of files that were being written: their names, a full stop and six
// letters (WriteFileAtomically).
void RemoveHalfWritten(const fs::path& cells) {
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(cells)) {
    const fs::path ending = entry.path().stem().extension();
    const bool is_ours = ending == kResultEnding || ending == kModelEnding;
    if (is_ours && entry.path().extension().string().size() == 7 &&
        KindOf(entry.path()) == PathKind::kFile) {
      left.push_back(entry.path());
    }
  }
  for (const fs::path& path : left) fs::remove(path);
}

// The result of a finished cell; none where there is none, or it or its model cannot be believed,
// of which `redone` then tells.
std::optional<CellResult> ReadFinished(const fs::path& out,
                                       const Cell& cell,
                                       std::vector<std::string>& redone) {
  if (!Exists(ResultFileOf(out, cell))) return std::nullopt;
  try {
    CellResult result = ReadCellResult(ResultFileOf(out, cell), cell.id);
    const fs::path model = ModelFileOf(out, cell);
    if (Sha256Hex(ReadFile(model)) == result.model_sha256) return result;
    throw Error(
        {.path = model.string(), .reason = "is not the model that the cell was scored with"});
  } catch (const Error& error) {
    redone.push_back(fmt::format("{} is worked out again: {}", cell.id, error.what()));
    return std::nullopt;
  }
}

// Calls `work` and names the cell in an Error of it.
void NamingCell(const Cell& cell, const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    Error::Details details = error.details();
    details.reason = fmt::format("cell {}: {}", cell.id, details.reason);
    throw Error(std::move(details));
  }
}

void WorkOutMissing(const std::vector<std::size_t>& missing,
                    const StudyRunOptions& options,
                    StudyRun& run) {
  const int num_missing = static_cast<int>(missing.size());
  const int at_once = std::clamp(num_missing, 1, options.num_threads);
  const int threads_each = std::max(1, options.num_threads / at_once);
  datasets::ParallelForReporting(
      missing.size(), at_once, options.progress, "cells", [&](std::size_t k) {
        const Cell& cell = run.cells[missing[k]];
        CellResult& result = run.results[missing[k]];
        NamingCell(cell, [&] {
          result = WorkOut(run.study, run.data, cell, ModelFileOf(options.out, cell), threads_each);
        });
        WriteCellResult(ResultFileOf(options.out, cell), result);
      });
}

// Takes over what is finished and works out the rest.
void GatherResults(const StudyRunOptions& options, StudyRun& run) {
  std::vector<std::size_t> missing;
  run.results.resize(run.cells.size());
  for (std::size_t i = 0; i < run.cells.size(); ++i) {
    std::optional<CellResult> finished = ReadFinished(options.out, run.cells[i], run.redone);
    if (finished) {
      run.results[i] = std::move(*finished);
    } else {
      missing.push_back(i);
    }
  }
  run.num_resumed = run.cells.size() - missing.size();
  WorkOutMissing(missing, options, run);
}

}  // namespace

fs::path ResultFileOf(const fs::path& out, const Cell& cell) {
  return out / "cells" / (cell.id + kResultEnding);
}

fs::path ModelFileOf(const fs::path& out, const Cell& cell) {
  return out / "cells" / (cell.id + kModelEnding);
}

StudyRun RunStudy(const Study& study, const StudyRunOptions& options) {
  RequireOption(
      options.num_threads >= 1, "StudyRunOptions.num_threads", options.num_threads, "at least 1");
  StudyRun run{.study = study, .data = {}, .cells = MakeCells(study), .results = {}};
  RequireFolders(study, run.cells);
  const PinnedInputs inputs(options.out);
  PinStudy(inputs, study);
  run.data = PrepareStudyData(study, options.out / "data", options.num_threads, options.progress);
  PinData(inputs, run.data);
  if (LooksOnTheObject(run.cells)) {
    inputs.Pin("data.depth",
               DepthFingerprint(run.data.test ? *run.data.test : run.data.train) + "\n");
  }
  fs::create_directories(options.out / "cells");
  RemoveHalfWritten(options.out / "cells");
  GatherResults(options, run);
  WriteFileAtomically(options.out / "results.csv", ResultsCsv(run.cells, run.results));
  WriteFileAtomically(options.out / "times.csv", TimesCsv(run.results));
  const bool has_regions =
      std::any_of(run.results.begin(), run.results.end(), [](const CellResult& result) {
        return !result.search_space.stages.empty();
      });
  if (has_regions) {
    WriteFileAtomically(options.out / "search_space.csv", SearchSpaceCsv(run.results));
  }
  return run;
}

}  // namespace handcraft::experiments
