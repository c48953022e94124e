// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>

#include "datasets/formats/table.h"

namespace handcraft::datasets {

/// Whether the name says so: .libsvm or .svm.
[[nodiscard]] bool IsLibsvmText(const std::filesystem::path& path);

/// Reads libsvm's text: a sample a line, `label index:value index:value …`, indices from 1 and
/// rising, those left out 0. Columns are named by their indices, "1", "2", …, up to the largest one
/// there is or `min_columns`; the label column is "label", and labels are numbers in their shortest
/// form ("+1" is "1"). Throws Error with the line: no number where one is due, NaN and infinities,
/// an index that does not rise or is above 1000000, and a table of more than 2^28 numbers.
[[nodiscard]] Table ReadLibsvmTable(const std::filesystem::path& path, std::size_t min_columns = 0);

}  // namespace handcraft::datasets
