// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/evaluation/grasp_point_evaluation.h"

namespace handcraft::tools {

/// Evaluates a model file, still in memory, on a set that training has not seen, with the measures
/// `handcraft evaluate` has by default. Throws Error as EvaluateGraspPoints does.
[[nodiscard]] experiments::GraspPointEvaluation EvaluateHeldOut(
    std::span<const std::uint8_t> model_bytes,
    const datasets::LabelledImageSet& held_out,
    const experiments::EvaluationOptions& options);

/// The same for a model's metadata, below hc.metrics: keys held_out.split, .data_fingerprint,
/// .num_images, .num_pixels, .log_loss, and .auc, .accuracy, .best_pixel_accuracy each with
/// .NAME_low and .NAME_high of the 95 % interval over images. What is NaN is left out.
[[nodiscard]] std::map<std::string, std::string> MetadataOf(
    const experiments::GraspPointEvaluation& evaluation, const std::string& split);

}  // namespace handcraft::tools
