// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/runner/study.h"

namespace handcraft::experiments {

/// One combination of a study's methods and factors, in one repetition.
struct Cell {
  /// Told from every other by method, factors and repetition, in words that stay the same when
  /// other methods or values are added: "H2,ridge=0.1,repetition=1". A name for a file.
  std::string id;
  std::string method;
  std::vector<Setting> factors;  ///< its value of each factor
  int repetition = 1;            ///< from 1
  std::uint64_t seed = 1;        ///< study.seed + repetition − 1
  CellSettings settings;
};

/// The cells of a study: methods × factors × repetitions, the last changing fastest. Settings of
/// the study come first, then those of the method, then the factors. Throws Error(kUsage) when the
/// settings of a cell do not go together, naming the cell.
[[nodiscard]] std::vector<Cell> MakeCells(const Study& study);

}  // namespace handcraft::experiments
