// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "trainers/logistic_irls/downhill_step.h"
#include "trainers/logistic_irls/hessian_policy.h"
#include "trainers/logistic_irls/objective.h"

namespace handcraft::logistic {

/// Descent with exact gradients and a Hessian estimated from some rows (row_sampler.h), mended by
/// limited-memory BFGS (Nocedal and Wright 2006, algorithm 7.4, the sketch's factor in place of a
/// multiple of the identity). A step costs one pass over X, a fifteenth of a Hessian of all rows.
/// The sketch is drawn anew when steps get slow after the weights have changed.
///
/// Rows are drawn by leverage, p_i (1 − p_i) x̃_iᵀH⁻¹x̃_i, with the last sketch for H and the form
/// estimated from a random projection of H^{−1/2} x̃_i to eight dimensions: one pass over X.
/// Source: Drineas, Magdon-Ismail, Mahoney and Woodruff, "Fast approximation of matrix coherence
/// and statistical leverage", JMLR 2012, section 3.2.
class SketchedDescent {
 public:
  SketchedDescent(const Objective& objective,
                  HessianPolicy& policy,
                  std::size_t num_rows_wanted,
                  std::uint64_t seed);

  /// Draws a first sketch, by norm, and finds its aliased columns into the policy; then a second
  /// one, by leverage. What is linearly dependent in all rows is so in some: when no column is
  /// aliased here, none is at all.
  void Start(const Point& point);

  /// Ends with kNoDescent when it gets nowhere; `point` is then as good as it got. kQuasiSeparated
  /// is a suspicion here, for a step of Newton's to confirm.
  DescentReport Run(const Goal& goal, Point& point);

 private:
  RowSample Draw(const Point& point);
  bool Refresh(const Point& point);

  const Objective& objective_;
  HessianPolicy& policy_;
  std::size_t num_rows_wanted_;
  std::uint64_t seed_;
  std::uint64_t num_sketches_ = 0;
  std::optional<HessianFactor> factor_;
  Point factor_point_;  // where the sketch was taken: its scores alone
};

}  // namespace handcraft::logistic
