// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lib/core/rng.h"
#include "trainers/logistic_irls/objective.h"

namespace handcraft::logistic {

/// Draws about `num_wanted` rows so that the Hessian of the draw, each row weighted by 1/q_i, is
/// close to the one of all rows:
///   q_i = min(1, c (1/n + s_i / Σ s)),  s_i = p_i (1 − p_i) squared_norms[i],
/// each row on its own with probability q_i. Rows that weigh much in H are thus taken for certain.
/// With squared_norms[i] = ‖x̃_i‖² s_i bounds what the row adds to H; with x̃_iᵀH⁻¹x̃_i it is the
/// row's leverage, and the draw is close to H in every direction, small ones too. Source: Xu, Yang,
/// Roosta-Khorasani, Ré and Mahoney, "Sub-sampled Newton methods with non-uniform sampling", 2016
/// (block norm squares and block partial leverage scores).
[[nodiscard]] RowSample DrawRows(std::span<const double> squared_norms,
                                 std::span<const double> scores,
                                 std::size_t num_wanted,
                                 Rng& rng);

}  // namespace handcraft::logistic
