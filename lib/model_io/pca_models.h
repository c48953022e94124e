// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/model_io/model_writer.h"
#include "lib/model_io/provenance.h"

namespace handcraft::model_io {

/// Component k of a raw row x is Σ_j components[k][j] · (x[j] − feature_mean[j]) /
/// feature_scale[j].
struct PcaModel {
  std::vector<double> components = {};   ///< row-major, the first of them × num_features
  std::vector<double> eigenvalues = {};  ///< num_features, descending: of all components
  std::vector<double> feature_mean = {};
  std::vector<double> feature_scale = {};  ///< positive
};

/// Kind "pca", docs/model_format.md § 8: for analysis; the runtime does not load it. Deterministic.
/// Throws std::logic_error when sizes do not fit, Error(kBadInput) for a column name that is empty,
/// has a line break or is not UTF-8.
[[nodiscard]] ModelFile MakePcaModel(const std::vector<std::string>& column_names,
                                     const PcaModel& model,
                                     const Provenance& provenance);

}  // namespace handcraft::model_io
