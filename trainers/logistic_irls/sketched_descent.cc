// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/sketched_descent.h"

#include <cmath>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "trainers/logistic_irls/row_sampler.h"

namespace handcraft::logistic {
namespace {

constexpr std::size_t kMaxSecants = 20;
// A step that leaves more than this of gᵀH⁻¹g is slow, …
constexpr double kSlowRatio = 0.2;
// … and a sketch is stale when some score has moved farther than this since.
constexpr double kStaleChange = 0.5;

// A step and the change of gradient along it.
struct Secant {
  Eigen::VectorXd step;
  Eigen::VectorXd change;
};

Eigen::VectorXd SecantDirection(const std::deque<Secant>& secants,
                                const HessianFactor& factor,
                                const Eigen::VectorXd& gradient) {
  Eigen::VectorXd q = gradient;
  std::vector<double> alphas(secants.size());
  for (std::size_t k = secants.size(); k-- > 0;) {
    const Secant& s = secants[k];
    alphas[k] = s.step.dot(q) / s.step.dot(s.change);
    q -= alphas[k] * s.change;
  }
  Eigen::VectorXd direction = factor.Solve(q);
  for (std::size_t k = 0; k < secants.size(); ++k) {
    const Secant& s = secants[k];
    const double beta = s.change.dot(direction) / s.step.dot(s.change);
    direction += (alphas[k] - beta) * s.step;
  }
  return direction;
}

// P of size × k with E[P Pᵀ] = I: ‖Pᵀv‖² estimates ‖v‖², here to a half (Achlioptas 2003).
Eigen::MatrixXd DrawProjection(Eigen::Index size, Rng& rng) {
  constexpr Eigen::Index kDimensions = 8;
  const double length = 1.0 / std::sqrt(static_cast<double>(kDimensions));
  Eigen::MatrixXd signs(size, kDimensions);
  for (double& sign : signs.reshaped()) sign = (rng.Next() >> 63U) != 0 ? length : -length;
  return signs;
}

void Remember(const Point& from, const Point& to, std::deque<Secant>& secants) {
  Secant secant{.step = to.theta - from.theta, .change = to.gradient - from.gradient};
  if (secant.step.dot(secant.change) > 0.0) secants.push_back(std::move(secant));
  if (secants.size() > kMaxSecants) secants.pop_front();
}

}  // namespace

SketchedDescent::SketchedDescent(const Objective& objective,
                                 HessianPolicy& policy,
                                 std::size_t num_rows_wanted,
                                 std::uint64_t seed)
    : objective_(objective), policy_(policy), num_rows_wanted_(num_rows_wanted), seed_(seed) {}

// By norm for the first sketch, when there is no H yet, then by leverage in the last one.
RowSample SketchedDescent::Draw(const Point& point) {
  Rng rng = Rng::Stream(seed_, "logistic_irls.sketch", num_sketches_++);
  const auto size = static_cast<Eigen::Index>(objective_.NumFeatures()) + 1;
  Eigen::MatrixXd map = DrawProjection(size, rng);
  if (factor_) map = factor_->InverseRootTimes(map);
  return DrawRows(objective_.SquaredNorms(map), point.scores, num_rows_wanted_, rng);
}

void SketchedDescent::Start(const Point& point) {
  const RowSample pilot = Draw(point);
  factor_ = policy_.Start(point, &pilot);
  if (factor_) Refresh(point);
}

bool SketchedDescent::Refresh(const Point& point) {
  const RowSample sample = Draw(point);
  factor_ = policy_.ForStep(point, &sample);
  factor_point_.scores = point.scores;
  return factor_.has_value();
}

DescentReport SketchedDescent::Run(const Goal& goal, Point& point) {
  const auto num_rows = static_cast<double>(objective_.NumRows());
  DescentReport report;
  std::deque<Secant> secants;
  Point trial;
  double previous_decrement = std::numeric_limits<double>::infinity();
  while (factor_) {
    Eigen::VectorXd step = SecantDirection(secants, *factor_, point.gradient);
    double decrement = point.gradient.dot(step);
    if (decrement > kSlowRatio * previous_decrement &&
        objective_.MovementBetween(factor_point_, point).largest > kStaleChange) {
      if (!Refresh(point)) break;
      secants.clear();
      step = factor_->Solve(point.gradient);
      decrement = point.gradient.dot(step);
    }
    const bool is_reached = decrement <= goal.mean_square_change * num_rows;
    if (is_reached || report.iterations >= goal.max_iterations) {
      report.end = is_reached ? DescentEnd::kReached : DescentEnd::kIterationLimit;
      break;
    }
    if (!StepDownhill(objective_, step, point, trial, report.step_halvings)) break;
    ++report.iterations;
    previous_decrement = decrement;
    if (IsCompletelySeparated(objective_, point)) {
      report.end = DescentEnd::kCompletelySeparated;
      break;
    }
    if (IsQuasiSeparated(objective_, trial, point)) {
      report.end = DescentEnd::kQuasiSeparated;
      break;
    }
    Remember(trial, point, secants);
  }
  return report;
}

}  // namespace handcraft::logistic
