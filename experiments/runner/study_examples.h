// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/runner/study_summary.h"

namespace handcraft::experiments {

/// A picture to test with, as a series sees it.
struct ExampleOverlay {
  std::string label;  ///< of the series
  BestPixelCounts best;
  std::vector<std::uint8_t> jpeg;
};

/// A picture that every series was tested with in the first repetition (the dissertation's Figure
/// 3.9): its labels, and what each series makes of it.
struct Example {
  std::string image;
  std::string object_class;
  std::vector<std::uint8_t> labels_jpeg;
  std::vector<ExampleOverlay> overlays;  ///< one a series
};

/// Up to max_count pictures, evenly spread, scored anew by the models below `out`. Throws Error
/// when a picture or a model cannot be read.
[[nodiscard]] std::vector<Example> MakeExamples(const StudyRun& run,
                                                const StudySummary& summary,
                                                const std::filesystem::path& out,
                                                std::size_t max_count);

}  // namespace handcraft::experiments
