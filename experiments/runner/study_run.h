// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/runner/cell_result.h"
#include "experiments/runner/grid.h"
#include "experiments/runner/study.h"
#include "experiments/runner/study_data.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

struct StudyRunOptions {
  std::filesystem::path out;  ///< folder of the results; made, or gone on with
  int num_threads = 1;        ///< ≥ 1; changes no byte of the results
  Progress progress = {};
};

/// A study with all its cells worked out.
struct StudyRun {
  Study study;
  StudyData data = {};
  std::vector<Cell> cells = {};
  std::vector<CellResult> results = {};  ///< one a cell
  std::size_t num_resumed = 0;           ///< cells that an earlier run had finished
  /// What of an earlier run could not be believed and was worked out again: a sentence a cell.
  std::vector<std::string> redone = {};
};

/// The file of a finished cell, and that of its model, below the folder of the results.
[[nodiscard]] std::filesystem::path ResultFileOf(const std::filesystem::path& out,
                                                 const Cell& cell);
[[nodiscard]] std::filesystem::path ModelFileOf(const std::filesystem::path& out, const Cell& cell);

/// Works out every cell: trains it, scores the pictures to test with by the runtime, forms the
/// figures. Cells are worked out in parallel; each finished one is a file below OUT/cells, so that
/// a run that was stopped at any moment is gone on with. OUT/inputs pins study, data and version:
/// a run with another of them is refused, by name. A file of a cell that is cut off or changed is
/// worked out again (StudyRun.redone). Writes results.csv and times.csv at the end,
/// and search_space.csv when a cell looks in the region of the object.
/// Same study and data, same bytes but for the times, however often it was stopped and for any
/// number of threads. Throws Error.
[[nodiscard]] StudyRun RunStudy(const Study& study, const StudyRunOptions& options);

}  // namespace handcraft::experiments
