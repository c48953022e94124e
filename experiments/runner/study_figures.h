// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "experiments/runner/bar_figure.h"
#include "experiments/runner/study_summary.h"

namespace handcraft::experiments {

/// A figure of the report and the name of its files.
struct NamedFigure {
  std::string name;
  BarFigure figure;
};

/// Best-pixel accuracy by class, a bar a series (the dissertation's Figures 3.7 and 3.8); and how
/// far each series is from the baseline on the same images, where there is another method; and how
/// long scoring and training took (Figures 3.10 and 3.11), mean over repetitions.
[[nodiscard]] std::vector<NamedFigure> FiguresOf(const StudyRun& run, const StudySummary& summary);

}  // namespace handcraft::experiments
