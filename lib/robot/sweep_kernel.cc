// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/robot/sweep_kernel.h"

#include <bit>
#include <cmath>
#include <cstdint>

// As in lib/features/pixel_kernels.cc: Highway's headers, its library not.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#define HWY_IS_DEBUG_BUILD 0
#define HWY_TARGET_INCLUDE "lib/robot/sweep_kernel.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/robot/sweep_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace handcraft::robot::internal {
namespace HWY_NAMESPACE {

// What no sample changes, in all lanes.
struct Constants {
  explicit Constants(const SweepJob& job_in) : job(job_in) {
    const SphericalJoint& shoulder = job.arm->shoulder;
    const Vector3& w = job.wrist_in_first;
    level2 = w[0] * w[0] + w[1] * w[1];
    is_shoulder_singular = level2 < 1e-24;
    reference1 = {std::cos(job.limits[0].reference), std::sin(job.limits[0].reference)};
    reference5 = {std::cos(job.limits[4].reference), std::sin(job.limits[4].reference)};
    shoulder_skew = {Constant(shoulder.cos_12), Constant(shoulder.sin_12)};
    shoulder_skew_23 = {Constant(shoulder.cos_23), Constant(shoulder.sin_23)};
    wrist_skew = {Constant(job.arm->wrist.cos_12), Constant(job.arm->wrist.sin_12)};
    wrist_skew_23 = {Constant(job.arm->wrist.cos_23), Constant(job.arm->wrist.sin_23)};
  }
  const SweepJob& job;
  double level2 = 0.0;  // squared distance of w from axis 1
  bool is_shoulder_singular = false;
  std::array<double, 2> reference1{};
  std::array<double, 2> reference5{};
  Turn shoulder_skew, shoulder_skew_23, wrist_skew, wrist_skew_23;
};

// The samples of one vector and what the elbow and they give.
struct Sample {
  Mask is_valid;
  Doubles free_rad;
  Turn turn3;
  Doubles u_x, u_y, u_z;  // shoulder to wrist after axis 3
  Doubles k;              // y after axis 2
  Doubles t;              // |x| after axis 2
  Doubles y;              // after the skew of axes 1 and 2
  Doubles inverse_u2;     // 1 / (u_x² + u_y²)
  Doubles inverse_level;  // 1 / product of the lengths of (t, y) and of w off axis 1
  Doubles cost;           // of joints 3 and 4
};

HWY_INLINE Sample TakeSample(const Constants& c, std::size_t first) {
  const SweepJob& job = c.job;
  Sample s;
  s.free_rad = Load(job.free_rad + first);
  s.turn3 = {Load(job.cosines + first), Load(job.sines + first)};
  Vector v = {Constant(job.wrist_in_third[0]),
              Constant(job.wrist_in_third[1]),
              Constant(job.wrist_in_third[2])};
  v = TurnX(c.shoulder_skew_23, TurnZ(s.turn3, v));
  s.u_x = v.x;
  s.u_y = v.y;
  s.u_z = v.z;
  s.k = hn::Mul(hn::NegMulAdd(c.shoulder_skew.cosine, v.z, Constant(job.wrist_in_first[2])),
                Constant(1.0 / job.arm->shoulder.sin_12));
  const Doubles length2 = hn::MulAdd(v.x, v.x, hn::Mul(v.y, v.y));
  const Doubles rest = hn::NegMulAdd(s.k, s.k, length2);
  // Rounding may leave a touching solution slightly below 0.
  s.is_valid = hn::And(hn::Ge(rest, Constant(-1e-15)), hn::Gt(length2, Constant(1e-18)));
  const Mask is_wanted = hn::Lt(hn::Iota(DoubleTag(), static_cast<double>(first)),
                                Constant(static_cast<double>(job.count)));
  s.is_valid = hn::And(s.is_valid, is_wanted);
  const Doubles t2 = hn::Max(rest, Constant(0.0));
  s.t = hn::Sqrt(t2);
  s.y = hn::NegMulAdd(c.shoulder_skew.sine, s.u_z, hn::Mul(c.shoulder_skew.cosine, s.k));
  s.inverse_u2 = Inverse(length2);
  s.inverse_level = Inverse(hn::Sqrt(hn::Mul(hn::MulAdd(s.y, s.y, t2), Constant(c.level2))));
  s.cost = CostOf(job.limits[2], s.free_rad, Constant(job.elbow_cost));
  return s;
}

// Joints 1 and 2 for one of the two signs of x after axis 2.
struct Shoulder {
  Turn turn1, turn2;
  Doubles q1, q2, cost;
  Mask is_valid;
};

HWY_INLINE Shoulder SolveShoulder(const Constants& c, const Sample& s, double sign) {
  const SweepJob& job = c.job;
  Shoulder shoulder;
  const Doubles x = hn::Mul(Constant(sign), s.t);
  // (c₂, s₂) turns (u_x, u_y) to (x, k), which is as long.
  shoulder.turn2 = TurnBetween(s.u_x, s.u_y, x, s.k, s.inverse_u2);
  if (c.is_shoulder_singular) {
    shoulder.turn1 = {Constant(c.reference1[0]), Constant(c.reference1[1])};
  } else {
    shoulder.turn1 = TurnBetween(
        x, s.y, Constant(job.wrist_in_first[0]), Constant(job.wrist_in_first[1]), s.inverse_level);
  }
  shoulder.is_valid = s.is_valid;
  shoulder.q2 = WithinLimits(job.limits[1],
                             hn::Sub(Angle(shoulder.turn2), Constant(job.arm->shoulder.offset_rad)),
                             shoulder.is_valid);
  shoulder.q1 = WithinLimits(job.limits[0], Angle(shoulder.turn1), shoulder.is_valid);
  shoulder.cost = CostOf(job.limits[1], shoulder.q2, CostOf(job.limits[0], shoulder.q1, s.cost));
  return shoulder;
}

// A wanted direction as the wrist's first frame sees it behind joints 1 to 4.
HWY_INLINE Vector BehindElbow(const Constants& c,
                              const Sample& s,
                              const Shoulder& shoulder,
                              const Vector3& wanted) {
  Vector v = {Constant(wanted[0]), Constant(wanted[1]), Constant(wanted[2])};
  v = TurnX(Back(c.shoulder_skew), TurnZ(Back(shoulder.turn1), v));
  v = TurnX(Back(c.shoulder_skew_23), TurnZ(Back(shoulder.turn2), v));
  v = TurnZ(Back(s.turn3), v);
  const Matrix3& m = c.job.fifth_from_third;
  const auto row = [&](std::size_t i) {
    return hn::MulAdd(
        Constant(m[i]), v.x, hn::MulAdd(Constant(m[i + 1]), v.y, hn::Mul(Constant(m[i + 2]), v.z)));
  };
  return {row(0), row(3), row(6)};
}

struct Solutions {
  Doubles q1, q2, q3, q5, q6, q7, cost;
};

// Writes those of the valid lanes one after the other. (Compressing vectors is slower: Highway 1.0
// copies a table for it.)
HWY_INLINE std::size_t Write(Mask is_valid, const Solutions& all, double q4, double* to) {
  alignas(64) double lanes[kSolutionSize][HWY_MAX_BYTES / sizeof(double)];
  const Doubles values[] = {all.q1, all.q2, all.q3, Constant(q4), all.q5, all.q6, all.q7, all.cost};
  for (std::size_t i = 0; i < kSolutionSize; ++i) hn::Store(values[i], DoubleTag(), lanes[i]);
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(DoubleTag(), is_valid, bytes);
  std::size_t count = 0;
  for (unsigned int bits = bytes[0]; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
    for (std::size_t i = 0; i < kSolutionSize; ++i) to[i] = lanes[i][lane];
    to += kSolutionSize;
    ++count;
  }
  return count;
}

// The wanted z axis behind the elbow is Rz(θ₅) (m, b, ·) with m = ± sin θ₆ sin α₆₇.
struct Wrist {
  Vector z;
  Doubles cos6, b, m, level2;
  Mask is_reached;
};

HWY_INLINE Wrist WristBehind(const Constants& c, const Sample& s, const Shoulder& shoulder) {
  const SphericalJoint& wrist = c.job.arm->wrist;
  const Vector z = BehindElbow(c, s, shoulder, c.job.goal_z_in_first);
  const Doubles cos6 = hn::Mul(hn::Sub(Constant(wrist.cos_12 * wrist.cos_23), z.z),
                               Constant(1.0 / (wrist.sin_12 * wrist.sin_23)));
  const Doubles b = hn::Neg(hn::MulAdd(
      Constant(wrist.cos_12 * wrist.sin_23), cos6, Constant(wrist.sin_12 * wrist.cos_23)));
  const Doubles level2 = hn::MulAdd(z.x, z.x, hn::Mul(z.y, z.y));
  const Doubles rest = hn::NegMulAdd(b, b, level2);
  const Mask is_reached = hn::And(shoulder.is_valid, hn::Ge(rest, Constant(-1e-14)));
  return {z, cos6, b, hn::Sqrt(hn::Max(rest, Constant(0.0))), level2, is_reached};
}

// Joints 5, 6, 7 for both signs of sin θ₆; appends what is within the limits.
HWY_INLINE std::size_t SolveWrist(const Constants& c,
                                  const Sample& s,
                                  const Shoulder& shoulder,
                                  std::size_t num_written) {
  const SweepJob& job = c.job;
  const SphericalJoint& joint = job.arm->wrist;
  const Wrist wrist = WristBehind(c, s, shoulder);
  const Vector x = BehindElbow(c, s, shoulder, job.goal_x_in_first);
  const Mask is_singular = hn::Lt(wrist.level2, Constant(1e-28));
  const Doubles inverse_level = Inverse(wrist.level2);  // (m, b) is as long as (z_x, z_y)
  for (const double sign : {1.0, -1.0}) {
    const Doubles signed_m = hn::Mul(Constant(sign), wrist.m);
    Turn turn5 = TurnBetween(signed_m, wrist.b, wrist.z.x, wrist.z.y, inverse_level);
    turn5.cosine = hn::IfThenElse(is_singular, Constant(c.reference5[0]), turn5.cosine);
    turn5.sine = hn::IfThenElse(is_singular, Constant(c.reference5[1]), turn5.sine);
    const Doubles sin6 = hn::Mul(signed_m, Constant(1.0 / joint.sin_23));
    const Turn turn6 = {wrist.cos6, sin6};
    Mask is_valid = wrist.is_reached;
    const Doubles q6 =
        WithinLimits(job.limits[5], hn::Sub(Angle(turn6), Constant(joint.offset_rad)), is_valid);
    const Doubles q5 = WithinLimits(job.limits[4], Angle(turn5), is_valid);
    // The wanted x is Rz(θ₅) Rx(α₅₆) Rz(θ₆) Rx(α₆₇) (c₇, s₇, 0).
    Vector v = TurnX(Back(c.wrist_skew), TurnZ(Back(turn5), x));
    v = TurnX(Back(c.wrist_skew_23), TurnZ(Back(turn6), v));
    const Doubles q7 = WithinLimits(job.limits[6], Angle({v.x, v.y}), is_valid);
    if (hn::AllFalse(DoubleTag(), is_valid)) continue;
    const Doubles cost = CostOf(
        job.limits[6], q7, CostOf(job.limits[5], q6, CostOf(job.limits[4], q5, shoulder.cost)));
    num_written += Write(is_valid,
                         {shoulder.q1, shoulder.q2, s.free_rad, q5, q6, q7, cost},
                         job.elbow_rad,
                         job.solutions + num_written * kSolutionSize);
  }
  return num_written;
}

std::size_t Sweep(const SweepJob& job) {
  const Constants constants(job);
  std::size_t num_written = 0;
  for (std::size_t first = 0; first < job.count; first += hn::Lanes(DoubleTag())) {
    const Sample sample = TakeSample(constants, first);
    if (hn::AllFalse(DoubleTag(), sample.is_valid)) continue;
    for (const double sign : {1.0, -1.0}) {
      const Shoulder shoulder = SolveShoulder(constants, sample, sign);
      if (hn::AllFalse(DoubleTag(), shoulder.is_valid)) continue;
      num_written = SolveWrist(constants, sample, shoulder, num_written);
    }
  }
  return num_written;
}

void Atan2All(const double* y, const double* x, double* angle, std::size_t count) {
  for (std::size_t i = 0; i < count; i += hn::Lanes(DoubleTag())) {
    hn::StoreU(Angle({Load(x + i), Load(y + i)}), DoubleTag(), angle + i);
  }
}

// Not inline: one table an instruction set, found by name below.
extern const SweepKernels kSweepKernels;
const SweepKernels kSweepKernels = {&Sweep, &Atan2All};

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::robot::internal
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace handcraft::robot::internal {

const SweepKernels& SweepFor(features::InstructionSet set) noexcept {
  switch (set) {
#if HWY_TARGETS & HWY_AVX3
    case features::InstructionSet::kAvx512:
      return N_AVX3::kSweepKernels;
#endif
#if HWY_TARGETS & HWY_AVX2
    case features::InstructionSet::kAvx2:
      return N_AVX2::kSweepKernels;
#endif
#if HWY_TARGETS & HWY_SSE4
    case features::InstructionSet::kSse4:
      return N_SSE4::kSweepKernels;
#endif
    default:
      return HWY_STATIC_DISPATCH(kSweepKernels);
  }
}

}  // namespace handcraft::robot::internal
#endif  // HWY_ONCE
