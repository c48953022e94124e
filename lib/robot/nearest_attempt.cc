// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/nearest_attempt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace handcraft::robot {
namespace {

constexpr std::size_t kRows = 6;  // shift [m], then turn times kRotationLength_m
using Row = std::array<double, kMaxJoints>;
using Residual = std::array<double, kRows>;

struct Linearised {
  Residual residual{};                // what is still to go
  std::array<Row, kRows> jacobian{};  // of the tip
  double squared = 0.0;
  PoseError error;
};

Linearised Linearise(const SerialChain& chain,
                     const Pose& goal,
                     std::span<const double> joints) noexcept {
  std::array<JointLine, kMaxJoints> lines;
  const Pose tip = ForwardKinematics(chain, joints, lines);
  Linearised at;
  const Vector3 shift = Subtract(goal.translation_m, tip.translation_m);
  const Vector3 turn = RotationVector(Multiply(goal.rotation, Transpose(tip.rotation)));
  at.error = {Norm(shift), Norm(turn)};
  at.squared = SquaredError(at.error);
  for (std::size_t i = 0; i < 3; ++i) {
    at.residual[i] = shift[i];
    at.residual[3 + i] = kRotationLength_m * turn[i];
  }
  for (std::size_t j = 0; j < chain.size(); ++j) {
    const bool is_revolute = chain.joints[j].type == JointType::kRevolute;
    const Vector3& axis = lines[j].axis;
    const Vector3 linear =
        is_revolute ? Cross(axis, Subtract(tip.translation_m, lines[j].point_m)) : axis;
    for (std::size_t i = 0; i < 3; ++i) {
      at.jacobian[i][j] = linear[i];
      at.jacobian[3 + i][j] = is_revolute ? kRotationLength_m * axis[i] : 0.0;
    }
  }
  return at;
}

// Solves (JᵀJ + damping · I) step = Jᵀ residual over the free joints, by Cholesky.
Row DampedStep(const Linearised& at,
               const std::array<bool, kMaxJoints>& is_free,
               std::size_t n,
               double damping) noexcept {
  std::array<Row, kMaxJoints> a{};
  Row step{};
  for (std::size_t i = 0; i < n; ++i) {
    a[i][i] = 1.0;
    if (!is_free[i]) continue;
    for (std::size_t r = 0; r < kRows; ++r) step[i] += at.jacobian[r][i] * at.residual[r];
    for (std::size_t j = 0; j <= i; ++j) {
      if (!is_free[j]) continue;
      double sum = i == j ? damping : 0.0;
      for (std::size_t r = 0; r < kRows; ++r) sum += at.jacobian[r][i] * at.jacobian[r][j];
      a[i][j] = sum;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(std::max(sum, 1e-300)) : sum / a[j][j];
    }
    for (std::size_t k = 0; k < i; ++k) step[i] -= a[i][k] * step[k];
    step[i] /= a[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) step[i] -= a[k][i] * step[k];
    step[i] /= a[i][i];
  }
  return step;
}

// A joint is held when it is at a limit and the error falls beyond it.
std::array<bool, kMaxJoints> FreeJoints(const SerialChain& chain,
                                        const Linearised& at,
                                        std::span<const double> joints) noexcept {
  std::array<bool, kMaxJoints> is_free{};
  for (std::size_t j = 0; j < chain.size(); ++j) {
    double descent = 0.0;
    for (std::size_t r = 0; r < kRows; ++r) descent += at.jacobian[r][j] * at.residual[r];
    const bool leans = (joints[j] <= chain.joints[j].lower && descent < 0.0) ||
                       (joints[j] >= chain.joints[j].upper && descent > 0.0);
    is_free[j] = !leans;
  }
  return is_free;
}

}  // namespace

double SquaredError(const PoseError& error) noexcept {
  const double turn_m = kRotationLength_m * error.rotation_rad;
  return error.position_m * error.position_m + turn_m * turn_m;
}

PoseError MoveToNearest(const SerialChain& chain,
                        const Pose& base_from_tip,
                        std::span<double> joints) noexcept {
  constexpr int kMaxSteps = 200;
  constexpr double kReached = 1e-30;  // [m²]
  constexpr double kLargestDamping = 1e8;
  const std::size_t n = chain.size();
  Linearised at = Linearise(chain, base_from_tip, joints);
  double damping = 1e-3;
  for (int i = 0; i < kMaxSteps && at.squared > kReached && damping < kLargestDamping; ++i) {
    // Damping goes with the error, so that the last steps are Gauss and Newton's.
    const Row step = DampedStep(
        at, FreeJoints(chain, at, joints), n, damping * std::min(at.squared, 1.0) + 1e-14);
    Row next{};
    for (std::size_t j = 0; j < n; ++j) {
      next[j] = std::clamp(joints[j] + step[j], chain.joints[j].lower, chain.joints[j].upper);
    }
    const Linearised there = Linearise(chain, base_from_tip, {next.data(), n});
    if (there.squared < at.squared) {
      const bool has_stalled = there.squared > (1.0 - 1e-9) * at.squared;
      std::copy_n(next.begin(), n, joints.begin());
      at = there;
      damping = std::max(0.1 * damping, 1e-6);
      if (has_stalled) break;
    } else {
      damping *= 10.0;
    }
  }
  return at.error;
}

}  // namespace handcraft::robot
