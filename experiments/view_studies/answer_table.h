// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include "experiments/view_studies/view_cell_result.h"

namespace handcraft::experiments {

/// Counts of answers as an HTML table whose cells are tinted by their share of the row: a confusion
/// matrix, or a histogram in each row. Zeros are left empty.
[[nodiscard]] std::string AnswerTable(const AnswerCounts& answers);

}  // namespace handcraft::experiments
