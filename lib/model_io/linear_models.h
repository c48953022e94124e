// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/features/feature_spec.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/provenance.h"

namespace handcraft::model_io {

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

}  // namespace handcraft::model_io
