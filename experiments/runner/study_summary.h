// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/paired.h"
#include "experiments/runner/study_run.h"

namespace handcraft::experiments {

/// What a method does with one choice of factors on the pictures of a class, or on all.
struct ClassSummary {
  PooledFigures figures;
  std::optional<Difference> difference = {};  ///< to the baseline; none for itself
};

/// A method with one choice of factors, over all repetitions.
struct SeriesSummary {
  std::string label;  ///< "H2", "H2, ridge = 0.1"
  std::string method;
  std::vector<std::size_t> cells = {};      ///< index into the run, one a repetition
  std::vector<ClassSummary> by_class = {};  ///< as StudySummary.classes, all at the end
  /// Over all pictures, means over repetitions: of the figures of the cells, and of the ends of
  /// their intervals, which are thus a cell's own where there is one repetition.
  Estimate auc = {};
  Estimate average_precision = {};
  ConfusionMatrix confusion = {};         ///< of all repetitions together
  ConfusionMatrix strict_confusion = {};  ///< the same, at 0.9
  SearchSpaceFigures search_space = {};   ///< without stages where there is no region
};

/// Whether a publication's claim holds on these data.
struct ClaimVerdict {
  std::string worst;     ///< label of the series that loses most
  Estimate loss_points;  ///< of its best-pixel accuracy over all pictures, in points
  bool holds = false;    ///< loss_points.value ≤ Claim.worst_loss_points
};

struct StudySummary {
  std::vector<std::string> classes;  ///< by name, "all" at the end
  std::vector<SeriesSummary> series;
  std::optional<ClaimVerdict> verdict = {};
  std::vector<std::string> warnings = {};  ///< cells whose training found no optimum
};

/// Puts the cells together: figures over repetitions, differences to the baseline method with the
/// same factors on the same pictures, verdict. Pure and deterministic.
[[nodiscard]] StudySummary SummariseStudy(const StudyRun& run, int num_threads);

}  // namespace handcraft::experiments
