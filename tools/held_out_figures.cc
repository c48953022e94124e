// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/held_out_figures.h"

#include <cmath>
#include <string>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/fields.h"

namespace handcraft::tools {

experiments::GraspPointEvaluation EvaluateHeldOut(std::span<const std::uint8_t> model_bytes,
                                                  const datasets::LabelledImageSet& held_out,
                                                  const experiments::EvaluationOptions& options) {
  const experiments::LoadedModel model = experiments::LoadModel(model_bytes);
  return experiments::EvaluateGraspPoints(model.get(), held_out, options);
}

std::map<std::string, std::string> MetadataOf(const experiments::GraspPointEvaluation& evaluation,
                                              const std::string& split) {
  const experiments::GroupFigures& all = evaluation.all;
  std::map<std::string, std::string> metadata = {
      {"held_out.split", split},
      {"held_out.data_fingerprint", evaluation.data_fingerprint},
      {"held_out.num_images", NumberToText(all.num_images)},
      {"held_out.num_pixels", NumberToText(all.confusion.Total())}};
  const auto add = [&](const std::string& name, double value) {
    if (!std::isnan(value)) metadata["held_out." + name] = NumberToText(value);
  };
  const auto add_estimate = [&](const std::string& name, const experiments::Estimate& estimate) {
    add(name, estimate.value);
    add(name + "_low", estimate.low);
    add(name + "_high", estimate.high);
  };
  add("log_loss", all.log_loss.value);
  add_estimate("auc", all.auc);
  add_estimate("accuracy", all.accuracy);
  add_estimate("best_pixel_accuracy", all.best_pixel_accuracy);
  return metadata;
}

}  // namespace handcraft::tools
