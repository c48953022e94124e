// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lib/core/image.h"
#include "lib/features/feature_spec.h"
#include "lib/model_io/model_writer.h"

namespace handcraft::model_io {

/// What every model file says about its origin (metadata, docs/model_format.md). Empty strings are
/// left out.
struct Provenance {
  std::string name;
  std::string version = "1";
  std::string task;
  std::string licence;
  std::string intended_use;
  std::string limits;
  std::string algorithm;                                ///< "logistic_irls"
  std::string data_fingerprint;                         ///< SHA-256 of the training data
  std::map<std::string, std::string> hyper_parameters;  ///< written as hc.training.<key>
  std::map<std::string, std::string> metrics;           ///< written as hc.metrics.<key>
};

/// z = intercept + Σ weights · x on raw inputs: the normaliser is already folded in;
/// feature_mean and feature_scale say what it was.
struct LinearModel {
  std::vector<double> weights;  ///< num_features
  double intercept = 0.0;
  std::vector<double> feature_mean;
  std::vector<double> feature_scale;
};

/// Kind "grasp_point": the linear model with its filters, window and energy, and self-test vectors
/// (a small picture drawn from a fixed seed → expected probabilities, computed here).
[[nodiscard]] ModelFile MakeGraspPointModel(const features::FeatureSpec& spec,
                                            const LinearModel& model,
                                            const Provenance& provenance);

/// Kind "logistic": probability of `positive_label` for a row of the named columns. Self-test rows
/// are taken from the mean and scale.
[[nodiscard]] ModelFile MakeLogisticModel(const std::vector<std::string>& column_names,
                                          const std::string& label_column,
                                          const std::string& negative_label,
                                          const std::string& positive_label,
                                          const LinearModel& model,
                                          const Provenance& provenance);

}  // namespace handcraft::model_io
