// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <span>

#include "lib/core/design_matrix.h"
#include "lib/linear_algebra/scatter.h"

namespace handcraft::lda {

/// The share λ in [0, 1] by which the pooled correlation matrix R should be shrunk, (1 − λ)R + λI,
/// so that its expected squared distance from the true one is least:
///   λ = min(1, (Σ_i ‖z_i‖⁴ / n − ‖R‖²) / n / ‖R − I‖²),  z_i = (x_i − mean of its class) / scale,
/// R = Σ z_i z_iᵀ / n, norms of Frobenius; 0 when R is I. `scatter` is that of X by class; a column
/// whose `scale` (divisor n) is 0 is left out.
/// Sums in fixed blocks, in order: the number of threads changes no bit.
/// Source: Ledoit and Wolf 2004, "A well-conditioned estimator for large-dimensional covariance
/// matrices", Lemmas 3.2 to 3.4.
template <class T>
[[nodiscard]] double LedoitWolfShare(const DesignMatrix<T>& X,
                                     std::span<const std::uint8_t> labels,
                                     const Scatter& scatter,
                                     std::span<const double> scale,
                                     int num_threads);

extern template double LedoitWolfShare(const DesignMatrix<float>&,
                                       std::span<const std::uint8_t>,
                                       const Scatter&,
                                       std::span<const double>,
                                       int);
extern template double LedoitWolfShare(const DesignMatrix<double>&,
                                       std::span<const std::uint8_t>,
                                       const Scatter&,
                                       std::span<const double>,
                                       int);

}  // namespace handcraft::lda
