// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/downhill_step.h"

#include <cmath>
#include <utility>

namespace handcraft::logistic {
namespace {

bool Improves(const Point& from, const Point& to) {
  constexpr double kRounding = 1e-14;  // a gain below this share of the value is rounding
  if (!std::isfinite(to.value) || !to.gradient.allFinite()) return false;
  if (to.value < from.value) return true;
  return to.value <= from.value * (1.0 + kRounding) &&
         to.gradient.lpNorm<Eigen::Infinity>() < from.gradient.lpNorm<Eigen::Infinity>();
}

}  // namespace

bool StepDownhill(const Objective& objective,
                  const Eigen::VectorXd& step,
                  Point& point,
                  Point& trial,
                  int& step_halvings) {
  constexpr int kMaxHalvings = 30;
  double share = 1.0;
  for (int halving = 0; halving <= kMaxHalvings; ++halving, share *= 0.5) {
    objective.Evaluate(point.theta - share * step, trial);
    if (Improves(point, trial)) {
      step_halvings += halving;
      std::swap(point, trial);
      return true;
    }
  }
  return false;
}

bool IsCompletelySeparated(const Objective& objective, const Point& point) {
  constexpr double kMargin = 1e-9;  // beyond the rounding of the scores
  return objective.ridge() == 0.0 && point.smallest_margin > kMargin;
}

bool IsQuasiSeparated(const Objective& objective, const Point& from, const Point& to) {
  constexpr double kVanishedGradient = 1e-8;
  if (objective.ridge() > 0.0 || to.GradientNorm() > kVanishedGradient) return false;
  const Movement movement = objective.MovementBetween(from, to);
  return movement.largest >= 0.1 && movement.smallest >= -1e-3 * movement.largest;
}

}  // namespace handcraft::logistic
