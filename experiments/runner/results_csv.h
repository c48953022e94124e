// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>

#include "experiments/runner/cell_result.h"
#include "experiments/runner/grid.h"

namespace handcraft::experiments {

/// results.csv: a row for each cell and class, and one for all classes; columns cell, method, the
/// factors, repetition, class, then the figures (docs/studies.md). Numbers read back as they are;
/// what cannot be formed is empty. Neither times nor anything else that changes from run to run.
[[nodiscard]] std::string ResultsCsv(std::span<const Cell> cells,
                                     std::span<const CellResult> results);

/// search_space.csv: a row a stage of search-space reduction, for cells whose region is the object;
/// pixels and times are means over pictures.
[[nodiscard]] std::string SearchSpaceCsv(std::span<const CellResult> results);

/// times.csv: a row a cell.
[[nodiscard]] std::string TimesCsv(std::span<const CellResult> results);

}  // namespace handcraft::experiments
