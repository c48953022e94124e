// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "trainers/logistic_irls/hessian_factor.h"
#include "trainers/logistic_irls/objective.h"

namespace handcraft::logistic {

/// Decides in which arithmetic a Hessian is formed and which columns it leaves out.
///
/// Newton's fixed point does not depend on the Hessian's precision, only the number of steps does:
/// single precision is twice as fast and serves as long as the problem is well conditioned.
class HessianPolicy {
 public:
  HessianPolicy(const Objective& objective, HessianPrecision precision)
      : objective_(objective), precision_(precision) {}

  /// Forms the Hessian at `point` (of the sample's rows, or of all) in double, to find the aliased
  /// columns (none with ridge) and to see whether single precision may be trusted. Its factor is
  /// returned for the first step; nothing when it is not positive definite.
  std::optional<HessianFactor> Start(const Point& point, const RowSample* sample = nullptr);

  /// The factor for a step. Under kAuto, falls back to double for good once single precision shows
  /// a reciprocal condition below 1e-4. A Hessian that is not positive definite (saturated samples)
  /// gets a growing multiple of its mean diagonal: a shorter step, still downhill.
  std::optional<HessianFactor> ForStep(const Point& point, const RowSample* sample = nullptr);

  /// The factor of all rows in double, as it is.
  [[nodiscard]] std::optional<HessianFactor> Exact(const Point& point) const;

  void InsistOnDouble() noexcept { precision_ = HessianPrecision::kDouble; }

  /// Whether ForStep works in double for now.
  [[nodiscard]] bool UsesDouble() const noexcept {
    return precision_ == HessianPrecision::kDouble || fell_back_to_double_;
  }
  [[nodiscard]] bool fell_back_to_double() const noexcept { return fell_back_to_double_; }
  [[nodiscard]] const std::vector<Eigen::Index>& aliased() const noexcept { return aliased_; }

 private:
  [[nodiscard]] Eigen::MatrixXd Form(const Point& point,
                                     const RowSample* sample,
                                     bool in_double) const;
  [[nodiscard]] std::optional<HessianFactor> FactorOrDamp(const Point& point,
                                                          const RowSample* sample,
                                                          bool in_double) const;

  const Objective& objective_;
  HessianPrecision precision_;
  bool fell_back_to_double_ = false;
  std::vector<Eigen::Index> aliased_;
};

}  // namespace handcraft::logistic
