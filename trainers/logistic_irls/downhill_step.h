// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "trainers/logistic_irls/objective.h"

namespace handcraft::logistic {

/// When a descent may stop. With g the gradient, n the rows and D the deviance:
struct Goal {
  double gradient_norm = 0.0;      ///< ‖g‖∞ ≤ this · n, and
  double relative_deviance = 0.0;  ///< |D − D_previous| ≤ this · (|D| + 0.1), and
  double mean_square_change = 0.0;  ///< gᵀH⁻¹g ≤ this · n: what the next step would move scores by
  int max_iterations = 0;
};

enum class DescentEnd {
  kReached,
  kIterationLimit,
  kCompletelySeparated,  ///< every sample has P > ½: a plane tells the classes apart
  kQuasiSeparated,       ///< a direction in which no sample loses, and the fit improves for ever
  kNoDescent,            ///< no step lowers the objective
};

struct DescentReport {
  DescentEnd end = DescentEnd::kNoDescent;
  int iterations = 0;
  int step_halvings = 0;
};

/// Moves `point` to θ − step, θ − step/2, θ − step/4 …: to the first place where the objective is
/// lower by 1e-4 of what its slope promises (Armijo), or where it is the same within 1e-10 and its
/// slope along the step is smaller: scores of nearly collinear features cancel, so the objective is
/// known to fewer digits than the gradient. `trial` then holds where it was.
/// Leaves it alone and returns false when thirty halvings find none.
/// Source: Nocedal and Wright 2006, section 3.1; Hager and Zhang 2005, section 3.
bool StepDownhill(const Objective& objective,
                  const Eigen::VectorXd& step,
                  Point& point,
                  Point& trial,
                  int& step_halvings);

/// A proof that there is no optimum: all samples are on their side of the plane at `point`, and no
/// ridge holds the weights back.
[[nodiscard]] bool IsCompletelySeparated(const Objective& objective, const Point& point);

/// A Newton step that still moves some score by a tenth or more, to no sample's loss, although the
/// gradient is all but gone: the optimum lies at infinity in that direction. In a regular problem
/// the last steps shrink quadratically, and there are losers.
[[nodiscard]] bool IsQuasiSeparated(const Objective& objective, const Point& from, const Point& to);

}  // namespace handcraft::logistic
