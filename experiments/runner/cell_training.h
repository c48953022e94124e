// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/runner/study.h"

namespace handcraft::experiments {

/// A cell's model and what its training came to.
struct CellTraining {
  std::vector<std::uint8_t> model = {};  ///< the bytes of a model file
  std::size_t num_images = 0;            ///< that gave samples
  std::size_t num_samples = 0;
  std::size_t num_features = 0;
  std::string termination = {};  ///< "converged", or why the weights are not an optimum's
  double log_loss = 0.0;         ///< mean over the samples, of the weights found
  double features_time_s = 0.0;
  double training_time_s = 0.0;
};

/// Draws pixels of the sets, as many of each to within one, computes their features and trains on
/// them, as `handcraft train grasp-points` does. An end without an optimum is told in
/// `termination`; the weights are then the last ones. Throws Error as DrawSamples,
/// ComputeSampleFeatures and TrainLogistic do. Same arguments, same model bytes, for any number of
/// threads.
[[nodiscard]] CellTraining TrainCell(std::span<const datasets::LabelledImageSet> sets,
                                     const CellSettings& settings,
                                     StudySplit split,
                                     std::uint64_t seed,
                                     int num_threads);

}  // namespace handcraft::experiments
