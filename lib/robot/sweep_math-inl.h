// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Vector arithmetic of the sweep: part of sweep_kernel.cc, compiled once for each instruction set.

#if defined(HANDCRAFT_SWEEP_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HANDCRAFT_SWEEP_MATH_INL_H_
#undef HANDCRAFT_SWEEP_MATH_INL_H_
#else
#define HANDCRAFT_SWEEP_MATH_INL_H_
#endif

#include <hwy/highway.h>

#include "lib/robot/sweep_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace handcraft::robot::internal {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::ScalableTag<double>;
using Doubles = hn::Vec<DoubleTag>;
using Mask = hn::Mask<DoubleTag>;

HWY_INLINE Doubles Load(const double* p) { return hn::LoadU(DoubleTag(), p); }
HWY_INLINE Doubles Constant(double value) { return hn::Set(DoubleTag(), value); }

// An angle by its cosine and sine, or by multiples of them.
struct Turn {
  Doubles cosine, sine;
};

struct Vector {
  Doubles x, y, z;
};

HWY_INLINE Turn Back(const Turn& turn) { return {turn.cosine, hn::Neg(turn.sine)}; }

HWY_INLINE Vector TurnZ(const Turn& turn, const Vector& v) {
  return {hn::NegMulAdd(turn.sine, v.y, hn::Mul(turn.cosine, v.x)),
          hn::MulAdd(turn.sine, v.x, hn::Mul(turn.cosine, v.y)),
          v.z};
}

HWY_INLINE Vector TurnX(const Turn& turn, const Vector& v) {
  return {v.x,
          hn::NegMulAdd(turn.sine, v.z, hn::Mul(turn.cosine, v.y)),
          hn::MulAdd(turn.sine, v.y, hn::Mul(turn.cosine, v.z))};
}

// The turn that brings the direction of (x, y) to that of (to_x, to_y); `inverse_lengths` is 1 over
// the product of their lengths.
HWY_INLINE Turn
TurnBetween(Doubles x, Doubles y, Doubles to_x, Doubles to_y, Doubles inverse_lengths) {
  return {hn::Mul(inverse_lengths, hn::MulAdd(x, to_x, hn::Mul(y, to_y))),
          hn::Mul(inverse_lengths, hn::NegMulAdd(y, to_x, hn::Mul(x, to_y)))};
}

HWY_INLINE Doubles Inverse(Doubles value) {
  return hn::Div(Constant(1.0), hn::Max(value, Constant(1e-300)));
}

// The angle in [−π, π], within 1e-15: atan2(sine, cosine). With a = min / max of the two absolute
// values, atan a = atan((a − 1)/(a + 1)) + π/4 for a > tan(π/8), and atan r = r + r³ P(r²) there,
// P of degree 10 by mpmath 1.3's chebyfit on [0, 1.0001 tan²(π/8)], off by 6e-18.
HWY_INLINE Doubles Angle(const Turn& turn) {
  const Doubles x = hn::Abs(turn.cosine);
  const Doubles y = hn::Abs(turn.sine);
  const Doubles larger = hn::Max(hn::Max(x, y), Constant(1e-300));
  const Doubles smaller = hn::Min(x, y);
  const Mask is_steep = hn::Gt(smaller, hn::Mul(larger, Constant(0.41421356237309503)));
  const Doubles numerator = hn::IfThenElse(is_steep, hn::Sub(smaller, larger), smaller);
  const Doubles denominator = hn::IfThenElse(is_steep, hn::Add(smaller, larger), larger);
  const Doubles r = hn::Div(numerator, denominator);
  const Doubles r2 = hn::Mul(r, r);
  Doubles p = Constant(-0.019175404711104933678);
  for (const double coefficient : {0.039230447784793095235,
                                   -0.050854078345894842573,
                                   0.058581409048663282818,
                                   -0.066645105255089365988,
                                   0.076921831253768920895,
                                   -0.090909045753064890845,
                                   0.11111111015187018721,
                                   -0.14285714284665680761,
                                   0.19999999999995516545,
                                   -0.33333333333333330156}) {
    p = hn::MulAdd(p, r2, Constant(coefficient));
  }
  constexpr double kQuarter = 0.78539816339744830962;
  Doubles angle = hn::MulAdd(hn::Mul(p, r2), r, r);
  angle = hn::Add(angle, hn::IfThenElseZero(is_steep, Constant(kQuarter)));
  angle = hn::IfThenElse(hn::Gt(y, x), hn::Sub(Constant(2.0 * kQuarter), angle), angle);
  angle = hn::IfThenElse(
      hn::Lt(turn.cosine, Constant(0.0)), hn::Sub(Constant(4.0 * kQuarter), angle), angle);
  return hn::IfThenElse(hn::Lt(turn.sine, Constant(0.0)), hn::Neg(angle), angle);
}

// The angle, by whole turns nearest to the middle of the limits, and no more valid where it is
// outside them; rounding just outside is brought back.
HWY_INLINE Doubles WithinLimits(const SweepLimit& limit, Doubles angle, Mask& is_valid) {
  constexpr double kTurn = 6.28318530717958647693;
  constexpr double kRounding = 1e-12;
  const Doubles off = hn::Sub(angle, Constant(limit.middle));
  const Doubles turns = hn::Round(hn::Mul(off, Constant(1.0 / kTurn)));
  const Doubles wrapped = hn::NegMulAdd(turns, Constant(kTurn), off);
  const Doubles half = Constant(limit.half);
  is_valid = hn::And(is_valid, hn::Le(hn::Abs(wrapped), hn::Add(half, Constant(kRounding))));
  const Doubles kept = hn::Max(hn::Min(wrapped, half), hn::Neg(half));
  return hn::Add(kept, Constant(limit.middle));
}

// cost + ((q − reference) · inverse)².
HWY_INLINE Doubles CostOf(const SweepLimit& limit, Doubles q, Doubles cost) {
  const Doubles share =
      hn::Mul(hn::Sub(q, Constant(limit.reference)), Constant(limit.inverse_half_range));
  return hn::MulAdd(share, share, cost);
}

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::robot::internal
HWY_AFTER_NAMESPACE();

#endif  // HANDCRAFT_SWEEP_MATH_INL_H_
