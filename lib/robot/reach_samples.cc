// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/reach_samples.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>

namespace handcraft::robot {
namespace {

constexpr std::size_t kGrid = 180;
constexpr double kStep = 2.0 * std::numbers::pi / kGrid;
// Squared lengths [m²] below 0 by no more than this are rounding.
constexpr double kRounding = 1e-12;

// The angle near a maximum of a smooth function between two angles, by golden sections.
double MaximumBetween(double lower, double upper, const std::function<double(double)>& f) {
  constexpr double kGolden = 0.6180339887498949;
  double a = upper - kGolden * (upper - lower);
  double b = lower + kGolden * (upper - lower);
  double f_a = f(a);
  double f_b = f(b);
  for (int i = 0; i < 80; ++i) {
    if (f_a < f_b) {
      lower = a;
      a = b;
      f_a = f_b;
      b = lower + kGolden * (upper - lower);
      f_b = f(b);
    } else {
      upper = b;
      b = a;
      f_b = f_a;
      a = upper - kGolden * (upper - lower);
      f_a = f(a);
    }
  }
  return 0.5 * (lower + upper);
}

// Where f, ≥ 0 at `inside`, ends to be so on the way to `outside`: the last angle at which it is.
double EndBetween(double inside, double outside, const std::function<double(double)>& f) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (inside + outside);
    (f(middle) >= 0.0 ? inside : outside) = middle;
  }
  return inside;
}

// The first angle of the grid, going from `start` by `step`, at which f < 0; half a turn away at
// most.
double FirstOutside(double start, double step, const std::function<double(double)>& f) {
  double angle = start + step;
  for (std::size_t i = 0; i < kGrid / 2 && f(angle) >= 0.0; ++i) angle += step;
  return angle;
}

}  // namespace

std::vector<double> ReachSamples(const SphericalJoint& shoulder,
                                 const Vector3& wrist_in_third,
                                 const Vector3& wrist_in_first) {
  const auto room = [&](double theta) {
    const Vector3 v = Multiply(AxisRotation({0, 0, 1}, theta), wrist_in_third);
    const double y = shoulder.cos_23 * v[1] - shoulder.sin_23 * v[2];
    const double z = shoulder.sin_23 * v[1] + shoulder.cos_23 * v[2];
    const double k = (wrist_in_first[2] - shoulder.cos_12 * z) / shoulder.sin_12;
    return v[0] * v[0] + y * y - k * k;
  };
  std::array<double, kGrid> values{};
  for (std::size_t i = 0; i < kGrid; ++i) values[i] = room(kStep * static_cast<double>(i));
  std::vector<double> samples;
  for (std::size_t i = 0; i < kGrid; ++i) {
    const bool is_peak =
        values[i] >= values[(i + kGrid - 1) % kGrid] && values[i] >= values[(i + 1) % kGrid];
    if (!is_peak) continue;
    const double at = kStep * static_cast<double>(i);
    const double peak = MaximumBetween(at - kStep, at + kStep, room);
    if (room(peak) < -kRounding) continue;
    samples.push_back(peak);
    if (room(peak) < 0.0) continue;
    const double lower = EndBetween(peak, FirstOutside(peak, -kStep, room), room);
    const double upper = EndBetween(peak, FirstOutside(peak, kStep, room), room);
    constexpr int kBetween = 64;
    for (int part = 0; part <= kBetween; ++part) {
      samples.push_back(lower + (upper - lower) * part / kBetween);
    }
  }
  for (double& sample : samples) sample = std::remainder(sample, 2.0 * std::numbers::pi);
  return samples;
}

}  // namespace handcraft::robot
