// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>
#include <vector>

#include "lib/features/feature_spec.h"
#include "lib/model_io/model_writer.h"

namespace handcraft::model_io {

/// What every model file says about its origin (metadata, docs/model_format.md). Empty strings are
/// left out.
struct Provenance {
  std::string name = {};
  std::string version = "1";
  std::string task = {};
  std::string licence = {};
  std::string intended_use = {};
  std::string limits = {};
  std::string algorithm = {};                                ///< "logistic_irls"
  std::string data_fingerprint = {};                         ///< SHA-256 of the training data
  std::string class_counts = {};                             ///< "0: 77094, 1: 77094"
  std::string parent = {};                                   ///< SHA-256 of the model it began with
  std::map<std::string, std::string> hyper_parameters = {};  ///< written as hc.training.<key>
  std::map<std::string, std::string> metrics = {};           ///< written as hc.metrics.<key>
};

/// z = intercept + Σ weights · x on raw inputs: the normaliser is already folded in;
/// feature_mean and feature_scale say what it was (both empty: there was none).
struct LinearModel {
  std::vector<double> weights = {};  ///< num_features
  double intercept = 0.0;
  std::vector<double> feature_mean = {};
  std::vector<double> feature_scale = {};
};

/// Kind "grasp_point": the linear model with its filters, window and energy, and self-test vectors
/// (a small picture drawn from a fixed seed → expected probabilities, computed here).
/// docs/model_format.md § 5. Deterministic. Throws std::logic_error when sizes do not fit.
[[nodiscard]] ModelFile MakeGraspPointModel(const features::FeatureSpec& spec,
                                            const LinearModel& model,
                                            const Provenance& provenance);

/// Kind "logistic": probability of `positive_label` for a row of the named columns. Self-test rows
/// are taken from the mean and scale. docs/model_format.md § 6. Throws std::logic_error when sizes
/// do not fit, Error(kBadInput) for a column name that is empty, has a line break or is not UTF-8.
[[nodiscard]] ModelFile MakeLogisticModel(const std::vector<std::string>& column_names,
                                          const std::string& label_column,
                                          const std::string& negative_label,
                                          const std::string& positive_label,
                                          const LinearModel& model,
                                          const Provenance& provenance);

/// The columns of a model of kind "logistic", in the order of its weights. Throws Error(kBadInput)
/// for another kind.
[[nodiscard]] std::vector<std::string> ColumnNamesOf(const ModelFile& model);

}  // namespace handcraft::model_io
