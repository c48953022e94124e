// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/downhill_step.h"

#include <cmath>
#include <utility>

namespace handcraft::logistic {
namespace {

// Whether θ − share · step is a sufficient gain (Armijo's rule). Where the objective cannot tell,
// its slope along the step must: Hager and Zhang 2005, "approximate Wolfe conditions".
bool Improves(const Point& from, const Point& to, const Eigen::VectorXd& step, double share) {
  constexpr double kSufficient = 1e-4;
  constexpr double kRounding = 1e-10;  // a change below this share of the objective may be rounding
  if (!std::isfinite(to.value) || !to.gradient.allFinite()) return false;
  const double slope = from.gradient.dot(step);
  const double gain = from.value - to.value;
  if (std::abs(gain) > kRounding * from.value) return gain >= kSufficient * share * slope;
  return std::abs(to.gradient.dot(step)) < slope;
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
    if (Improves(point, trial, step, share)) {
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
