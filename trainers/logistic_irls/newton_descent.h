// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "trainers/logistic_irls/downhill_step.h"
#include "trainers/logistic_irls/hessian_factor.h"
#include "trainers/logistic_irls/hessian_policy.h"
#include "trainers/logistic_irls/objective.h"

namespace handcraft::logistic {

/// Newton's method on all rows, θ ← θ − H⁻¹g with step halving, keeping the factor of a Hessian as
/// long as every step with it divides gᵀH⁻¹g by a hundred (the chord method): near the optimum a
/// factor lasts to the end.
class NewtonDescent {
 public:
  NewtonDescent(const Objective& objective, HessianPolicy& policy)
      : objective_(objective), policy_(policy) {}

  /// `first_factor`: the Hessian's at `point`, if it is there already.
  DescentReport Run(const Goal& goal,
                    Point& point,
                    std::optional<HessianFactor> first_factor = std::nullopt);

  /// The factor of the exact Hessian at `point`: the last one used if it is in double and was taken
  /// within `largest_change` in every score, else a new one. Nothing when not positive definite.
  std::optional<HessianFactor> ExactFactor(const Point& point, double largest_change);

  /// Of the last Hessian used; 0 before the first.
  [[nodiscard]] double reciprocal_condition() const noexcept {
    return factor_ ? factor_->reciprocal_condition() : 0.0;
  }

 private:
  std::optional<DescentEnd> StepWhileFactorServes(const Goal& goal,
                                                  Point& point,
                                                  DescentReport& report);

  const Objective& objective_;
  HessianPolicy& policy_;
  std::optional<HessianFactor> factor_;
  bool factor_is_double_ = false;
  Point factor_point_;  // where the factor was taken: its scores alone
  Point trial_;
  double previous_deviance_ = std::numeric_limits<double>::infinity();
};

}  // namespace handcraft::logistic
