// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace handcraft::experiments {

struct ScikitLearnFit {
  double seconds = 0.0;            ///< of the fit alone
  double processor_seconds = 0.0;  ///< the same, of processor time
  double log_loss = 0.0;           ///< mean, nats
  int iterations = 0;
  std::string version;
};

/// Fits the matrix (row-major labels.size() × num_features) with scikit-learn's newton-cholesky in
/// a python3 of its own, BLAS held to one thread; see peers/newton_cholesky.py. Hands the data over
/// through files in `scratch`. Nothing when there is no python3 with scikit-learn ≥ 1.2: first the
/// one on the PATH is tried, then the system's.
[[nodiscard]] std::optional<ScikitLearnFit> FitWithScikitLearn(
    std::span<const float> features,
    std::span<const std::uint8_t> labels,
    const std::filesystem::path& scratch);

}  // namespace handcraft::experiments
