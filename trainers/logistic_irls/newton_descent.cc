// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/newton_descent.h"

#include <cmath>
#include <utility>

namespace handcraft::logistic {
namespace {

constexpr double kMaxChordRatio = 1e-2;
constexpr double kRoundingChange = 1e-19;  // mean square of a change of scores
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<DescentEnd> NewtonDescent::StepWhileFactorServes(const Goal& goal,
                                                               Point& point,
                                                               DescentReport& report) {
  const auto num_rows = static_cast<double>(objective_.NumRows());
  double previous_decrement = kInfinity;
  while (true) {
    const Eigen::VectorXd step = factor_->Solve(point.gradient);
    const double decrement = point.gradient.dot(step);
    const bool is_close = point.GradientNorm(policy_.aliased()) <= goal.gradient_norm &&
                          std::abs(point.deviance - previous_deviance_) <=
                              goal.relative_deviance * (std::abs(point.deviance) + 0.1);
    const bool is_slow = decrement > kMaxChordRatio * previous_decrement;
    if (is_close && decrement <= goal.mean_square_change * num_rows) return DescentEnd::kReached;
    // Close, and tiny steps that no longer shrink: what is left is rounding.
    if (is_close && is_slow && decrement <= kRoundingChange * num_rows) return DescentEnd::kReached;
    if (report.iterations >= goal.max_iterations) {
      return is_close ? DescentEnd::kReached : DescentEnd::kIterationLimit;
    }
    if (is_slow) return std::nullopt;
    const double deviance = point.deviance;
    if (!StepDownhill(objective_, step, point, trial_, report.step_halvings)) {
      if (is_close) return DescentEnd::kReached;
      if (std::isinf(previous_decrement)) return DescentEnd::kNoDescent;
      return std::nullopt;
    }
    ++report.iterations;
    previous_deviance_ = deviance;
    previous_decrement = decrement;
    if (IsCompletelySeparated(objective_, point)) return DescentEnd::kCompletelySeparated;
    if (IsQuasiSeparated(objective_, trial_, point)) return DescentEnd::kQuasiSeparated;
  }
}

DescentReport NewtonDescent::Run(const Goal& goal,
                                 Point& point,
                                 std::optional<HessianFactor> first_factor) {
  DescentReport report;
  factor_ = std::move(first_factor);
  factor_is_double_ = factor_.has_value();
  while (true) {
    if (!factor_) {
      factor_ = policy_.ForStep(point);
      factor_is_double_ = policy_.UsesDouble();
    }
    if (!factor_) return report;
    factor_point_.scores = point.scores;
    if (const auto end = StepWhileFactorServes(goal, point, report)) {
      report.end = *end;
      return report;
    }
    factor_.reset();
  }
}

std::optional<HessianFactor> NewtonDescent::ExactFactor(const Point& point, double largest_change) {
  const bool serves = factor_ && factor_is_double_ &&
                      objective_.MovementBetween(factor_point_, point).largest <= largest_change;
  return serves ? factor_ : policy_.Exact(point);
}

}  // namespace handcraft::logistic
