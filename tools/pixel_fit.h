// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <nlohmann/json.hpp>

#include "datasets/grasp_point_samples.h"
#include "lib/core/fields.h"
#include "lib/model_io/linear_models.h"
#include "tools/console.h"
#include "trainers/lda/lda.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::tools {

enum class FitMethod : std::uint8_t { kLogistic, kLda };

/// How `train grasp-points` finds the weights of a pixel's features.
struct PixelFitOptions {
  FitMethod method = FitMethod::kLogistic;
  logistic::Options logistic = {};
  lda::Options lda = {};
};

/// Adds --method and the options of both methods.
void AddPixelFitOptions(CLI::App& command, PixelFitOptions& options);

/// Throws Error(kUsage) that names an option given to `command` that belongs to the other method.
void RefuseOptionsOfOtherMethods(const CLI::App& command, const PixelFitOptions& options);

/// What either method leaves behind.
struct PixelFit {
  model_io::LinearModel model = {};
  std::string algorithm = {};  ///< as model files name it
  FieldTexts hyper_parameters = {};
  FieldTexts metrics = {};  ///< train.*, as model files keep them
  std::size_t num_samples = 0;
  std::size_t num_positive = 0;
  double deviance = 0.0;
  double null_deviance = 0.0;
  std::string message = {};          ///< how training ended, for people
  nlohmann::ordered_json json = {};  ///< what only this method knows, for machines
};

/// Fits the samples, with a progress bar; seed and threads are those of the sampling. Warns of
/// features without weight. Throws Error(kNoResult) when there is no model, Error as the trainers
/// do.
[[nodiscard]] PixelFit FitPixels(const datasets::GraspPointSamples& samples,
                                 const std::vector<std::string>& feature_names,
                                 PixelFitOptions options,
                                 const datasets::SamplingOptions& sampling,
                                 const Console& console);

}  // namespace handcraft::tools
