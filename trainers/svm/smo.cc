// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/smo.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "lib/core/check.h"
#include "lib/core/option_rules.h"

namespace handcraft::svm {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Curvature of a step along which the objective is flat or, with a kernel that is not positive
// definite, bends upwards (libsvm's TAU).
constexpr double kLeastCurvature = 1e-12;
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// State of the ascent. The gradient g_t = y_t − Σ_s K_ts β_s is libsvm's −y_t ∇_t.
class Ascent {
 public:
  Ascent(const KernelView& kernel, std::span<const double> y, std::span<const double> limits);

  SmoResult Run(const SmoOptions& options);

 private:
  [[nodiscard]] std::size_t SelectFirst() const noexcept;
  std::size_t SelectSecond(std::size_t first, double& violation) const noexcept;
  void Step(std::size_t first, std::size_t second) noexcept;
  void NoteBounds(std::size_t t) noexcept {
    can_rise_[t] = static_cast<std::uint8_t>(beta_[t] < upper_[t]);
    can_fall_[t] = static_cast<std::uint8_t>(beta_[t] > lower_[t]);
  }
  [[nodiscard]] double Intercept() const noexcept;
  [[nodiscard]] double Objective() const noexcept;

  const KernelView& kernel_;
  std::span<const double> y_;
  std::vector<double> lower_;
  std::vector<double> upper_;
  std::vector<double> beta_;
  std::vector<double> gradient_;
  std::vector<double> diagonal_;
  std::vector<std::uint8_t> can_rise_;  // I_up
  std::vector<std::uint8_t> can_fall_;  // I_low
};

Ascent::Ascent(const KernelView& kernel, std::span<const double> y, std::span<const double> limits)
    : kernel_(kernel),
      y_(y),
      lower_(y.size()),
      upper_(y.size()),
      beta_(y.size(), 0.0),
      gradient_(y.begin(), y.end()),
      diagonal_(y.size()),
      can_rise_(y.size()),
      can_fall_(y.size()) {
  for (std::size_t t = 0; t < y.size(); ++t) {
    lower_[t] = y[t] > 0.0 ? 0.0 : -limits[t];
    upper_[t] = y[t] > 0.0 ? limits[t] : 0.0;
    diagonal_[t] = kernel.Row(t)[t];
    NoteBounds(t);
  }
}

std::size_t Ascent::SelectFirst() const noexcept {
  std::size_t first = kNone;
  double largest = -kInfinity;
  for (std::size_t t = 0; t < beta_.size(); ++t) {
    if (can_rise_[t] != 0 && gradient_[t] >= largest) {
      largest = gradient_[t];
      first = t;
    }
  }
  return first;
}

// Of the samples that may fall, the one with the largest gain difference² / curvature; quotients
// are compared by their cross products.
std::size_t Ascent::SelectSecond(std::size_t first, double& violation) const noexcept {
  const double* row = kernel_.Row(first);
  const double top = gradient_[first];
  const double top_diagonal = diagonal_[first];
  std::size_t second = kNone;
  double least = kInfinity;
  double best_square = 0.0;
  double best_curvature = 1.0;
  for (std::size_t t = 0; t < beta_.size(); ++t) {
    if (can_fall_[t] == 0) continue;
    least = std::min(least, gradient_[t]);
    const double difference = top - gradient_[t];
    if (difference <= 0.0) continue;
    const double curvature = std::max(top_diagonal + diagonal_[t] - 2.0 * row[t], kLeastCurvature);
    const double square = difference * difference;
    if (square * best_curvature >= best_square * curvature) {
      best_square = square;
      best_curvature = curvature;
      second = t;
    }
  }
  violation = top - least;
  return second;
}

void Ascent::Step(std::size_t first, std::size_t second) noexcept {
  const double* first_row = kernel_.Row(first);
  const double* second_row = kernel_.Row(second);
  const double curvature =
      std::max(diagonal_[first] + diagonal_[second] - 2.0 * first_row[second], kLeastCurvature);
  const double free_step = (gradient_[first] - gradient_[second]) / curvature;
  const double rise = upper_[first] - beta_[first];
  const double fall = beta_[second] - lower_[second];
  const double step = std::min({free_step, rise, fall});
  // On a bound exactly: a coefficient beside it by one rounding would be taken for a free one.
  beta_[first] = step == rise ? upper_[first] : beta_[first] + step;
  beta_[second] = step == fall ? lower_[second] : beta_[second] - step;
  NoteBounds(first);
  NoteBounds(second);
  for (std::size_t t = 0; t < gradient_.size(); ++t) {
    gradient_[t] += step * (second_row[t] - first_row[t]);
  }
}

double Ascent::Intercept() const noexcept {
  double sum = 0.0;
  std::size_t num_free = 0;
  double up = -kInfinity;
  double low = kInfinity;
  for (std::size_t t = 0; t < beta_.size(); ++t) {
    if (can_rise_[t] != 0 && can_fall_[t] != 0) {
      sum += gradient_[t];
      ++num_free;
    } else if (can_rise_[t] != 0) {
      up = std::max(up, gradient_[t]);
    } else if (can_fall_[t] != 0) {
      low = std::min(low, gradient_[t]);
    }
  }
  return num_free > 0 ? sum / static_cast<double>(num_free) : (up + low) / 2.0;
}

// With g = y − Kβ: Σ yβ − βᵀKβ/2 = Σ β(y + g)/2.
double Ascent::Objective() const noexcept {
  double objective = 0.0;
  for (std::size_t t = 0; t < beta_.size(); ++t) {
    objective += 0.5 * beta_[t] * (y_[t] + gradient_[t]);
  }
  return objective;
}

SmoResult Ascent::Run(const SmoOptions& options) {
  SmoResult result;
  for (;;) {
    const std::size_t first = SelectFirst();
    const std::size_t second = first == kNone ? kNone : SelectSecond(first, result.violation);
    result.converged = second == kNone || result.violation < options.tolerance;
    if (result.converged || result.iterations == options.max_iterations) break;
    Step(first, second);
    ++result.iterations;
  }
  result.intercept = Intercept();
  result.objective = Objective();
  result.coefficients = std::move(beta_);
  return result;
}

}  // namespace

void SmoOptions::Validate() const {
  RequireOption(
      tolerance > 0.0 && tolerance <= 1.0, "svm::SmoOptions.tolerance", tolerance, "in (0, 1]");
  RequireOption(
      max_iterations >= 1, "svm::SmoOptions.max_iterations", max_iterations, "at least 1");
}

SmoResult SolveDual(const KernelView& kernel,
                    std::span<const double> y,
                    std::span<const double> limits,
                    const SmoOptions& options) {
  options.Validate();
  HC_CHECK(y.size() == kernel.size && limits.size() == kernel.size && kernel.stride >= kernel.size,
           y.size(),
           limits.size(),
           kernel.size,
           kernel.stride);
  return Ascent(kernel, y, limits).Run(options);
}

}  // namespace handcraft::svm
