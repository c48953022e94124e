// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/evaluation/grasp_point_evaluation.h"
#include "experiments/evaluation/grasp_point_figures.h"
#include "experiments/runner/cell_training.h"
#include "experiments/runner/search_space_figures.h"

namespace handcraft::experiments {

/// What a cell does on one picture: sums, from which the figures of any group of pictures follow.
struct ImageFigures {
  std::string image = {};  ///< its path in the set
  std::string object_class = {};
  BestPixelCounts best = {};
  std::size_t num_pixels = 0;      ///< labelled pixels scored
  ConfusionMatrix confusion = {};  ///< of them, at the threshold
  ConfusionMatrix strict_confusion = {};
  double log_loss_sum = 0.0;       ///< over those pixels
  double squared_error_sum = 0.0;  ///< over those pixels
};

/// Processor-independent results of a cell, and beside them its times.
struct CellResult {
  std::string id = {};
  std::string model_sha256 = {};  ///< of the cell's model file
  std::size_t num_training_images = 0;
  std::size_t num_samples = 0;
  std::size_t num_features = 0;
  std::string termination = {};
  double training_log_loss = 0.0;
  std::vector<GroupFigures> groups = {};  ///< the classes by name, then "all"
  std::vector<ImageFigures> images = {};  ///< in the order of the set
  PixelCurves curves = {};                ///< of at most 101 points
  SearchSpaceFigures search_space = {};
  double features_time_s = 0.0;
  double training_time_s = 0.0;
  double score_time_ms = 0.0;  ///< median of a picture
};

[[nodiscard]] CellResult MakeCellResult(const std::string& id,
                                        const CellTraining& training,
                                        const GraspPointEvaluation& evaluation,
                                        const datasets::LabelledImageSet& test);

/// A finished cell as a file of its own, with its checksum (SHA-256 of the text of the rest):
/// written atomically, read back bit for bit. Reading throws Error naming the file when it is cut
/// off, when anything in it has been changed since, or when it is of another cell.
void WriteCellResult(const std::filesystem::path& path, const CellResult& result);
[[nodiscard]] CellResult ReadCellResult(const std::filesystem::path& path, const std::string& id);

}  // namespace handcraft::experiments
