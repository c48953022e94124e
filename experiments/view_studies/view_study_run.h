// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "datasets/formats/view_set.h"
#include "experiments/view_studies/view_cell_result.h"
#include "experiments/view_studies/view_study.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

struct ViewStudyRunOptions {
  std::filesystem::path out;  ///< folder of the results; made, or gone on with
  int num_threads = 1;        ///< ≥ 1; changes no byte of the results
  Progress progress = {};
};

/// A study of views with all its cells worked out.
struct ViewStudyRun {
  ViewStudy study;
  datasets::ViewSet train = {};
  std::optional<datasets::ViewSet> test = {};
  std::vector<ViewCell> cells = {};
  std::vector<ViewCellResult> results = {};  ///< one a cell
};

/// Makes or reads the views, works out every cell and writes results.csv (a row a cell and group),
/// answers.csv (a row a cell, truth and answer that occurs) and times.csv; where there are such
/// figures also errors.csv (a row a cell and group) and rejection.csv (a row a cell and point).
/// Views that an earlier run has made are gone on with; cells take seconds and are always worked
/// out. OUT/inputs pins study, data and version: a run with another of them is refused, by name.
/// Same study and data, same bytes but for the times, for any number of threads. Throws Error.
[[nodiscard]] ViewStudyRun RunViewStudy(const ViewStudy& study, const ViewStudyRunOptions& options);

}  // namespace handcraft::experiments
