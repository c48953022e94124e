// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "lib/features/class_vote.h"
#include "lib/features/similarity.h"

namespace handcraft::model_io {

/// A support vector machine of several classes: machine m decides by
///   f_m(x) = intercepts[m] + Σ_k dual_coefficients[k] · K(support_vectors[machine_supports[k]],
///   x'),
/// k from machine_begins[m] to machine_begins[m + 1], x' = (x − feature_mean) / feature_scale, and
/// the class follows by features::VoteForClass. Pairs are ordered by their second class, and
/// support vectors by when they came, so that adding a class leaves every array here the beginning
/// of the new one.
struct SvmModel {
  features::Similarity similarity = {};
  features::ClassScheme scheme = features::ClassScheme::kOneAgainstOne;
  std::size_t num_classes = 0;
  std::vector<double> feature_mean = {};  ///< num_features; 0 when samples are taken as they are
  std::vector<double> feature_scale =
      {};  ///< num_features, > 0; 1 when samples are taken as they are
  std::vector<double> support_vectors =
      {};                         ///< row-major num_support_vectors × num_features, normalised
  bool single_precision = false;  ///< the support vectors are floats, and stored as such
  std::vector<std::int32_t> support_classes = {};   ///< the class of each support vector
  std::vector<std::int32_t> machine_begins = {};    ///< num_machines + 1, from 0
  std::vector<std::int32_t> machine_supports = {};  ///< ascending within a machine
  std::vector<double> dual_coefficients = {};       ///< y_i α_i
  std::vector<double> intercepts = {};              ///< num_machines; libsvm's −ρ
  std::optional<double> rejection_threshold = {};   ///< a margin below it is none of these classes

  [[nodiscard]] std::size_t NumFeatures() const noexcept { return feature_mean.size(); }
  [[nodiscard]] std::size_t NumSupportVectors() const noexcept { return support_classes.size(); }
  [[nodiscard]] std::size_t NumMachines() const noexcept { return intercepts.size(); }
};

}  // namespace handcraft::model_io
