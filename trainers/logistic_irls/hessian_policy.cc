// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/hessian_policy.h"

namespace handcraft::logistic {
namespace {

// Single precision errs by about 1e-6 of the largest entry of H; down to this reciprocal condition
// a step with it still removes 99 % of the error.
constexpr double kSafeConditionForSingle = 1e-4;

}  // namespace

Eigen::MatrixXd HessianPolicy::Form(const Point& point,
                                    const RowSample* sample,
                                    bool in_double) const {
  return in_double ? objective_.Hessian<double>(point, sample)
                   : objective_.Hessian<float>(point, sample);
}

std::optional<HessianFactor> HessianPolicy::Start(const Point& point, const RowSample* sample) {
  const Eigen::MatrixXd hessian = Form(point, sample, true);
  if (objective_.ridge() == 0.0) aliased_ = FindAliasedColumns(hessian);
  std::optional<HessianFactor> factor = HessianFactor::Make(hessian, aliased_);
  const bool is_safe = factor && factor->reciprocal_condition() >= kSafeConditionForSingle;
  if (precision_ == HessianPrecision::kAuto && !is_safe) fell_back_to_double_ = true;
  return factor;
}

std::optional<HessianFactor> HessianPolicy::ForStep(const Point& point, const RowSample* sample) {
  if (precision_ == HessianPrecision::kAuto && !fell_back_to_double_) {
    std::optional<HessianFactor> factor = HessianFactor::Make(Form(point, sample, false), aliased_);
    if (factor && factor->reciprocal_condition() >= kSafeConditionForSingle) return factor;
    fell_back_to_double_ = true;
  }
  return FactorOrDamp(point, sample, precision_ != HessianPrecision::kSingle);
}

std::optional<HessianFactor> HessianPolicy::FactorOrDamp(const Point& point,
                                                         const RowSample* sample,
                                                         bool in_double) const {
  Eigen::MatrixXd hessian = Form(point, sample, in_double);
  std::optional<HessianFactor> factor = HessianFactor::Make(hessian, aliased_);
  const double mean_diagonal = hessian.diagonal().mean();
  for (double share = in_double ? 1e-12 : 1e-6; share < 1.0 && !factor; share *= 100.0) {
    hessian.diagonal().array() += share * mean_diagonal;
    factor = HessianFactor::Make(hessian, aliased_);
  }
  return factor;
}

std::optional<HessianFactor> HessianPolicy::Exact(const Point& point) const {
  return HessianFactor::Make(Form(point, nullptr, true), aliased_);
}

}  // namespace handcraft::logistic
