// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Vector arithmetic shared by the kernels: part of pixel_kernels.cc, compiled once for each
// instruction set.

#if defined(HANDCRAFT_VECTOR_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HANDCRAFT_VECTOR_MATH_INL_H_
#undef HANDCRAFT_VECTOR_MATH_INL_H_
#else
#define HANDCRAFT_VECTOR_MATH_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace handcraft::features::internal {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using Floats = hn::Vec<FloatTag>;

HWY_INLINE Floats Load(const float* p) { return hn::LoadU(FloatTag(), p); }
HWY_INLINE Floats Constant(float value) { return hn::Set(FloatTag(), value); }
HWY_INLINE void Store(Floats v, float* p) { hn::StoreU(v, FloatTag(), p); }
HWY_INLINE int NumLanes() { return static_cast<int>(hn::Lanes(FloatTag())); }

// ln x for normal x > 0, within 2e-7 of |ln x| + 1: x = 2^k · m with m in [√½, √2), and
// ln m = f − f²/2 + f³ · P(f), f = m − 1 (P: Cephes' logf).
HWY_INLINE Floats NaturalLog(Floats x) {
  const hn::RebindToSigned<FloatTag> int_tag;
  const auto bits = hn::Sub(hn::BitCast(int_tag, x), hn::Set(int_tag, 0x3f3504f3));
  const auto exponent = hn::ShiftRight<23>(bits);
  const Floats mantissa =
      hn::BitCast(FloatTag(), hn::Sub(hn::BitCast(int_tag, x), hn::ShiftLeft<23>(exponent)));
  const Floats f = hn::Sub(mantissa, Constant(1.0F));
  Floats p = Constant(7.0376836292e-2F);
  for (const float coefficient : {-1.1514610310e-1F,
                                  1.1676998740e-1F,
                                  -1.2420140846e-1F,
                                  1.4249322787e-1F,
                                  -1.6668057665e-1F,
                                  2.0000714765e-1F,
                                  -2.4999993993e-1F,
                                  3.3333331174e-1F}) {
    p = hn::MulAdd(p, f, Constant(coefficient));
  }
  const Floats f2 = hn::Mul(f, f);
  const Floats tail = hn::MulAdd(hn::Mul(p, f), f2, hn::Mul(Constant(-0.5F), f2));
  const Floats k = hn::ConvertTo(FloatTag(), exponent);
  return hn::MulAdd(k, Constant(0.69314718056F), hn::Add(f, tail));
}

// 1 / (1 + e^{−z}), z kept to |z| ≤ 87. e^{−z} = 2^n · e^r with n = round(−z / ln 2); e^r by
// Cephes' expf polynomial, |r| ≤ ln 2 / 2.
HWY_INLINE Floats Sigmoid(Floats z) {
  const hn::RebindToSigned<FloatTag> int_tag;
  const Floats t = hn::Min(hn::Max(hn::Neg(z), Constant(-87.0F)), Constant(87.0F));
  const auto n = hn::NearestInt(hn::Mul(t, Constant(1.44269504089F)));
  const Floats n_float = hn::ConvertTo(FloatTag(), n);
  Floats r = hn::NegMulAdd(n_float, Constant(0.693359375F), t);
  r = hn::NegMulAdd(n_float, Constant(-2.12194440e-4F), r);
  Floats p = Constant(1.9875691500e-4F);
  for (const float coefficient :
       {1.3981999507e-3F, 8.3334519073e-3F, 4.1665795894e-2F, 1.6666665459e-1F, 5.0000001201e-1F}) {
    p = hn::MulAdd(p, r, Constant(coefficient));
  }
  const Floats exp_r = hn::Add(hn::MulAdd(p, hn::Mul(r, r), r), Constant(1.0F));
  const Floats power =
      hn::BitCast(FloatTag(), hn::ShiftLeft<23>(hn::Add(n, hn::Set(int_tag, 127))));
  return hn::Div(Constant(1.0F), hn::MulAdd(exp_r, power, Constant(1.0F)));
}

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::features::internal
HWY_AFTER_NAMESPACE();

#endif  // HANDCRAFT_VECTOR_MATH_INL_H_
