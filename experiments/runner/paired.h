// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "experiments/metrics/binary_metrics.h"
#include "experiments/runner/cell_result.h"

namespace handcraft::experiments {

/// The cells of one method and one choice of factors: one a repetition, in order.
using Repetitions = std::span<const CellResult* const>;

struct BootstrapOptions {
  std::size_t resamples = 1000;
  std::uint64_t seed = 1;
  int num_threads = 1;
};

/// What a method does over all repetitions, each figure with its 95 % interval. Pictures are the
/// groups of the bootstrap: a picture is drawn with what it gave in every repetition. With one
/// repetition they are the figures and intervals of its GroupFigures, bit for bit.
struct PooledFigures {
  std::size_t num_images = 0;
  Estimate best_pixel_accuracy = {};  ///< docs/evaluation.md
  Estimate accuracy = {};
  ConfusionRates rates = {};
  ConfusionRates strict_rates = {};  ///< at the probability that best pixels must exceed
  Estimate log_loss = {};
  Estimate brier = {};
};

/// What one method gains over another.
struct Difference : PooledFigures {
  /// Pictures on which both have a best pixel that counts, and the difference of the accuracy over
  /// them: a method that finds nothing on hard pictures is not better for it.
  std::size_t num_images_with_both = 0;
  Estimate best_pixel_accuracy_with_both = {};
};

/// Over the pictures of a class, over all when `object_class` is empty; by EstimateShare and
/// EstimateRatio (grouped_ratio.h).
[[nodiscard]] PooledFigures PoolFigures(Repetitions cells,
                                        const std::string& object_class,
                                        const BootstrapOptions& options);

/// The same figures as differences, `cells` minus `baseline`, over the pictures that both were
/// tested with in the same repetition. Both sides of a picture are drawn together: what makes it
/// hard for both does not widen the interval. Figures that either side lacks are NaN.
/// Source: Efron and Tibshirani 1993, "An Introduction to the Bootstrap", chapters 8 and 13.
[[nodiscard]] Difference CompareFigures(Repetitions cells,
                                        Repetitions baseline,
                                        const std::string& object_class,
                                        const BootstrapOptions& options);

}  // namespace handcraft::experiments
