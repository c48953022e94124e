// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/closed_form_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "lib/core/error.h"
#include "lib/robot/cost_order.h"
#include "lib/robot/nearest_attempt.h"
#include "lib/robot/reach_samples.h"
#include "lib/robot/sweep_kernel.h"

namespace handcraft::robot {
namespace {

constexpr std::size_t kNumJoints = 7;
constexpr std::size_t kElbow = 3;
constexpr std::size_t kFree = 2;

SphericalArm RequireSphericalArm(const SerialChain& chain) {
  SphericalArmSearch search = FindSphericalArm(chain);
  if (!search.arm) {
    throw Error({.kind = Error::Kind::kUsage,
                 .reason = "no closed form for '" + chain.tip + "': " + search.reason,
                 .remedy = "use the iterative solver"});
  }
  return *search.arm;
}

internal::SweepLimit SweepLimitOf(const Joint& joint, double reference, bool is_kept) {
  const double half = 0.5 * (joint.upper - joint.lower);
  return {.middle = joint.Middle(),
          .half = is_kept ? half : std::numeric_limits<double>::infinity(),
          .reference = reference,
          .inverse_half_range = 1.0 / half};
}

double Squared(double value) noexcept { return value * value; }

// Sum of the squares by which joints lie outside their limits.
double Violation(const SerialChain& chain, std::span<const double> joints) noexcept {
  double sum = 0.0;
  for (std::size_t j = 0; j < chain.size(); ++j) {
    sum += Squared(
        std::max({0.0, chain.joints[j].lower - joints[j], joints[j] - chain.joints[j].upper}));
  }
  return sum;
}

}  // namespace

std::size_t ClosedFormSolver::Samples::size() const noexcept {
  return angles_rad.size() - internal::kSweepSlack;
}

ClosedFormSolver::ClosedFormSolver(const SerialChain& chain,
                                   const InverseKinematicsOptions& options,
                                   features::InstructionSet set)
    : InverseKinematics(chain, options),
      arm_(RequireSphericalArm(chain)),
      set_(set),
      samples_(MakeSamples(GridOf(options.free_joint_step_rad))) {}

ClosedFormSolver::Samples ClosedFormSolver::MakeSamples(std::vector<double> angles_rad) {
  Samples samples{.angles_rad = std::move(angles_rad)};
  samples.angles_rad.resize(samples.angles_rad.size() + internal::kSweepSlack);
  for (const double angle : samples.angles_rad) {
    samples.cosines.push_back(std::cos(angle));
    samples.sines.push_back(std::sin(angle));
  }
  return samples;
}

std::vector<double> ClosedFormSolver::GridOf(double step_rad) const {
  const Joint& joint = chain().joints[kFree];
  // The last sample may be the upper limit, up to rounding.
  const auto num_steps = static_cast<std::size_t>((joint.upper - joint.lower) / step_rad + 1e-9);
  std::vector<double> angles;
  angles.reserve(num_steps + 1);
  for (std::size_t i = 0; i <= num_steps; ++i) {
    angles.push_back(std::min(joint.lower + step_rad * static_cast<double>(i), joint.upper));
  }
  return angles;
}

// The tip's pose moves the wrist's centre and turns what joint 7 carries:
//   R = R_goal · R_homeᵀ, wrist = t_goal + R (wrist_home − t_home).
ClosedFormSolver::Goal ClosedFormSolver::GoalOf(const Pose& base_from_tip) const noexcept {
  const Matrix3 turn = Multiply(base_from_tip.rotation, Transpose(arm_.base_from_tip.rotation));
  const Vector3 tip_to_wrist = Subtract(arm_.wrist.centre_m, arm_.base_from_tip.translation_m);
  const Vector3 wrist = Add(base_from_tip.translation_m, Multiply(turn, tip_to_wrist));
  const Matrix3 first_from_base = Transpose(arm_.shoulder.first_frame);
  const Matrix3 wanted = Multiply(first_from_base, Multiply(turn, arm_.wrist.third_frame));
  return {Multiply(first_from_base, Subtract(wrist, arm_.shoulder.centre_m)),
          Column(wanted, 0),
          Column(wanted, 2)};
}

// Both q₄ at which the wrist is as far from the shoulder as wanted; NaN where none is.
std::array<double, 2> ClosedFormSolver::ElbowsFor(const Goal& goal) const noexcept {
  constexpr double kRounding = 1e-12;
  const double amplitude = std::hypot(arm_.reach_cosine, arm_.reach_sine);
  const double cosine =
      (Dot(goal.wrist_in_first, goal.wrist_in_first) - arm_.reach_constant) / amplitude;
  if (!(std::abs(cosine) <= 1.0 + kRounding)) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  }
  const double peak = std::atan2(arm_.reach_sine, arm_.reach_cosine);
  const double off = std::acos(std::clamp(cosine, -1.0, 1.0));
  const double middle = chain().joints[kElbow].Middle();
  const auto near_middle = [&](double angle) {
    return middle + std::remainder(angle - middle, 2.0 * std::numbers::pi);
  };
  return {near_middle(peak - off), near_middle(peak + off)};
}

Matrix3 ClosedFormSolver::ElbowRotation(double q4) const noexcept {
  return AxisRotation(arm_.elbow.axis, q4);
}

Vector3 ClosedFormSolver::WristInThird(const Matrix3& elbow) const noexcept {
  const Vector3 forearm = Multiply(elbow, Subtract(arm_.wrist.centre_m, arm_.elbow.point_m));
  const Vector3 from_shoulder = Add(Subtract(arm_.elbow.point_m, arm_.shoulder.centre_m), forearm);
  return Multiply(Transpose(arm_.shoulder.third_frame), from_shoulder);
}

// Sets what belongs to one elbow angle.
void ClosedFormSolver::SetElbow(double q4, double reference, internal::SweepJob& job) const {
  const Matrix3 elbow = ElbowRotation(q4);
  job.wrist_in_third = WristInThird(elbow);
  job.fifth_from_third = Multiply(Transpose(arm_.wrist.first_frame),
                                  Multiply(Transpose(elbow), arm_.shoulder.third_frame));
  job.elbow_cost = Squared((q4 - reference) * job.limits[kElbow].inverse_half_range);
  job.elbow_rad = q4;
}

// Fills the result, sorted by cost, with what the samples give.
void ClosedFormSolver::Sweep(const Goal& goal,
                             const Samples& samples,
                             std::span<const double> reference,
                             Limits limits,
                             InverseKinematicsResult& result) const {
  const bool is_kept = limits == Limits::kKept;
  const std::size_t capacity =
      2 * internal::kSolutionsPerSample * internal::kSolutionSize * samples.size();
  if (result.scratch.size() < capacity) result.scratch.resize(capacity);
  internal::SweepJob job{.arm = &arm_,
                         .free_rad = samples.angles_rad.data(),
                         .cosines = samples.cosines.data(),
                         .sines = samples.sines.data(),
                         .count = samples.size(),
                         .wrist_in_first = goal.wrist_in_first,
                         .goal_x_in_first = goal.x_in_first,
                         .goal_z_in_first = goal.z_in_first};
  for (std::size_t j = 0; j < kNumJoints; ++j) {
    job.limits[j] = SweepLimitOf(chain().joints[j], reference[j], is_kept);
  }
  const Joint& elbow = chain().joints[kElbow];
  std::size_t count = 0;
  for (double q4 : ElbowsFor(goal)) {
    constexpr double kRounding = 1e-12;
    const bool is_within = q4 >= elbow.lower - kRounding && q4 <= elbow.upper + kRounding;
    if (std::isnan(q4) || (is_kept && !is_within)) continue;
    if (is_kept) q4 = std::clamp(q4, elbow.lower, elbow.upper);
    SetElbow(q4, reference[kElbow], job);
    job.solutions = result.scratch.data() + count * internal::kSolutionSize;
    count += internal::SweepFor(set_).sweep(job);
  }
  TakeSorted(count, result);
}

// Takes solutions from the scratch into joints and costs.
void ClosedFormSolver::TakeSorted(std::size_t count, InverseKinematicsResult& result) {
  result.joints.resize(count * kNumJoints);
  result.costs.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.costs[i] = result.scratch[i * internal::kSolutionSize + kNumJoints] / kNumJoints;
  }
  OrderByCost(result.costs, result.order, result.keys);
  for (std::size_t i = 0; i < count; ++i) {
    const double* const solution =
        result.scratch.data() + result.order[i] * internal::kSolutionSize;
    std::copy_n(solution, kNumJoints, result.joints.data() + i * kNumJoints);
    result.costs[i] = solution[kNumJoints] / kNumJoints;
  }
}

void ClosedFormSolver::SolveSound(const Pose& base_from_tip,
                                  std::span<const double> reference,
                                  InverseKinematicsResult& result) const {
  FindSound(base_from_tip, reference, result);
  if (result.IsSolved()) return;
  Approach(base_from_tip, WithinReach(GoalOf(base_from_tip)), reference, result);
  TakeFirstAsBest(base_from_tip, result);
}

void ClosedFormSolver::FindSound(const Pose& base_from_tip,
                                 std::span<const double> reference,
                                 InverseKinematicsResult& result) const {
  const Goal goal = GoalOf(base_from_tip);
  Sweep(goal, samples_, reference, Limits::kKept, result);
  if (!result.IsSolved()) {
    Sweep(goal, FineSamples(goal), reference, Limits::kKept, result);
    KeepExact(base_from_tip, reference, result);
  }
  TakeFirstAsBest(base_from_tip, result);
}

ClosedFormSolver::Samples ClosedFormSolver::FineSamples(const Goal& goal) const {
  constexpr double kFiner = 16.0;
  const Joint& joint = chain().joints[kFree];
  std::vector<double> angles = GridOf(options().free_joint_step_rad / kFiner);
  for (const double q4 : ElbowsFor(goal)) {
    if (std::isnan(q4)) continue;
    for (const double angle :
         ReachSamples(arm_.shoulder, WristInThird(ElbowRotation(q4)), goal.wrist_in_first)) {
      const double q3 =
          joint.Middle() + std::remainder(angle - joint.Middle(), 2.0 * std::numbers::pi);
      if (q3 >= joint.lower && q3 <= joint.upper) angles.push_back(q3);
    }
  }
  return MakeSamples(std::move(angles));
}

// Near a singular shoulder rounding grows: what is not exact is moved, what cannot be is dropped.
void ClosedFormSolver::KeepExact(const Pose& base_from_tip,
                                 std::span<const double> reference,
                                 InverseKinematicsResult& result) const {
  const std::vector<double> found = std::exchange(result.joints, {});
  result.costs.clear();
  for (std::size_t i = 0; i < found.size(); i += kNumJoints) {
    std::array<double, kNumJoints> joints{};
    std::copy_n(found.begin() + static_cast<std::ptrdiff_t>(i), kNumJoints, joints.begin());
    PoseError error = ErrorBetween(ForwardKinematics(chain(), joints), base_from_tip);
    if (!IsWithinTolerance(error)) error = MoveToNearest(chain(), base_from_tip, joints);
    if (IsWithinTolerance(error)) AddSolution(joints, reference, result);
  }
  SortSolutions(result);
}

// The goal with the wrist brought to where the elbow's limits let it be, along the same direction.
ClosedFormSolver::Goal ClosedFormSolver::WithinReach(const Goal& goal) const noexcept {
  const Joint& joint = chain().joints[kElbow];
  const double peak = std::atan2(arm_.reach_sine, arm_.reach_cosine);
  const auto squared_at = [&](double q4) {
    return arm_.reach_constant +
           std::hypot(arm_.reach_cosine, arm_.reach_sine) * std::cos(q4 - peak);
  };
  double nearest = std::min(squared_at(joint.lower), squared_at(joint.upper));
  double farthest = std::max(squared_at(joint.lower), squared_at(joint.upper));
  for (int half_turns = -3; half_turns <= 3; ++half_turns) {
    const double extreme = peak + half_turns * std::numbers::pi;
    if (extreme < joint.lower || extreme > joint.upper) continue;
    nearest = std::min(nearest, squared_at(extreme));
    farthest = std::max(farthest, squared_at(extreme));
  }
  const double squared = Dot(goal.wrist_in_first, goal.wrist_in_first);
  const double wanted = std::clamp(squared, nearest, farthest);
  Goal reached = goal;
  reached.wrist_in_first = squared > 1e-12 ? Scale(goal.wrist_in_first, std::sqrt(wanted / squared))
                                           : Vector3{std::sqrt(wanted), 0.0, 0.0};
  return reached;
}

// The best of the solutions without limits, and the reference, moved within the limits.
void ClosedFormSolver::Approach(const Pose& base_from_tip,
                                const Goal& goal,
                                std::span<const double> reference,
                                InverseKinematicsResult& result) const {
  constexpr std::size_t kNumStarts = 16;
  Sweep(goal, FineSamples(goal), reference, Limits::kIgnored, result);
  std::vector<double> starts = std::exchange(result.joints, {});
  result.costs.clear();
  starts.insert(starts.end(), reference.begin(), reference.end());
  const auto start = [&](std::size_t i) {
    return std::span<double>(starts).subspan(i * kNumJoints, kNumJoints);
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < starts.size() / kNumJoints; ++i) {
    order.emplace_back(Violation(chain(), start(i)), i);
    for (std::size_t j = 0; j < kNumJoints; ++j) {
      start(i)[j] = std::clamp(start(i)[j], chain().joints[j].lower, chain().joints[j].upper);
    }
  }
  std::sort(order.begin(), order.end());
  result.best = {.error = {std::numeric_limits<double>::infinity(), std::numbers::pi}};
  for (std::size_t i = 0; i < std::min(kNumStarts, order.size()); ++i) {
    const std::span<double> joints = start(order[i].second);
    const PoseError error = MoveToNearest(chain(), base_from_tip, joints);
    if (IsWithinTolerance(error)) AddSolution(joints, reference, result);
    if (SquaredError(error) < SquaredError(result.best.error)) {
      result.best.joints.assign(joints.begin(), joints.end());
      result.best.error = error;
    }
  }
  SortSolutions(result);
}

}  // namespace handcraft::robot
