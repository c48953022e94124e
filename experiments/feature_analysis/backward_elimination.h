// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "experiments/feature_analysis/held_out_fit.h"
#include "lib/core/progress.h"

namespace handcraft::experiments {

struct BackwardEliminationOptions {
  HeldOutFitOptions fit = {};
  int num_threads = 1;  ///< ≥ 1; changes no bit of the result
  Progress progress = {};
};

/// A fit after one more set of columns went.
struct EliminationStep {
  std::size_t removed = 0;  ///< which set
  double log_loss = 0.0;    ///< held out, without it
  double auc = 0.0;
  Estimate increase;  ///< of the log-loss above that of all columns
  std::size_t num_columns = 0;
};

struct BackwardElimination {
  HeldOutFit all;                      ///< with every column
  std::vector<EliminationStep> steps;  ///< one fewer than there are sets
  std::vector<std::size_t> order;      ///< the sets, first gone first; the one that stays is last
};

/// Takes one set of columns away after the other (all those of a filter, say): each time the one
/// whose going raises the held-out log-loss least (the first of equals), found by fitting without
/// each in turn, every fit begun at the weights of the last (warm start). `set_of_column` gives the
/// set, below num_sets ≥ 1, of each column of `data`.
/// The held-out samples choose, so their figures along the way are somewhat too good: measure the
/// chosen features on others.
/// Deterministic for any number of threads. Throws Error(kNoResult) as FitColumns does,
/// std::logic_error for sets that do not fit or have no column.
/// Source: Guyon and Elisseeff 2003, "An introduction to variable and feature selection", sec. 4.
[[nodiscard]] BackwardElimination EliminateBackward(const HeldOutData& data,
                                                    const std::vector<std::size_t>& set_of_column,
                                                    std::size_t num_sets,
                                                    const BackwardEliminationOptions& options);

}  // namespace handcraft::experiments
