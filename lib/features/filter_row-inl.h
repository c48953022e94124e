// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The energies of one row of pixels, compiled once for each instruction set: after the vertical
// halves of the kernels (filter_columns-inl.h), filter by filter, the horizontal half and the
// square. Masks: filter_bank.cc; tests compare.

#if defined(HANDCRAFT_FILTER_ROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HANDCRAFT_FILTER_ROW_INL_H_
#undef HANDCRAFT_FILTER_ROW_INL_H_
#else
#define HANDCRAFT_FILTER_ROW_INL_H_
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "lib/features/filter_columns-inl.h"
#include "lib/features/pixel_kernels.h"
#include "lib/features/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace handcraft::features::internal {
namespace HWY_NAMESPACE {
// Horizontal halves at t[0]; t points at the column of the energy.
HWY_INLINE Floats Sum(const float* t, int reach) {
  return hn::Add(Load(t - reach), Load(t + reach));
}
HWY_INLINE Floats Difference(const float* t, int reach) {
  return hn::Sub(Load(t + reach), Load(t - reach));
}
HWY_INLINE Floats LawsRow(const float* t, int kind) {
  const Floats two = Constant(2.0F);
  if (kind == 0) return hn::MulAdd(two, Load(t), Sum(t, 1));
  if (kind == 1) return Difference(t, 1);
  return hn::MulSub(two, Load(t), Sum(t, 1));
}
HWY_INLINE Floats SmoothRow5(const float* t) {
  return hn::MulAdd(Constant(4.0F), Sum(t, 1), hn::MulAdd(Constant(6.0F), Load(t), Sum(t, 2)));
}
HWY_INLINE Floats FirstRow5(const float* t) {
  return hn::MulAdd(Constant(2.0F), Difference(t, 1), Difference(t, 2));
}
HWY_INLINE Floats SecondRow5(const float* t) {
  return hn::NegMulAdd(Constant(2.0F), Load(t), Sum(t, 2));
}
HWY_INLINE Floats SmoothRow7(const float* t) {
  return hn::MulAdd(
      Constant(6.0F),
      Sum(t, 2),
      hn::MulAdd(Constant(15.0F), Sum(t, 1), hn::MulAdd(Constant(20.0F), Load(t), Sum(t, 3))));
}
HWY_INLINE Floats FirstRow7(const float* t) {
  return hn::MulAdd(Constant(4.0F),
                    Difference(t, 2),
                    hn::MulAdd(Constant(5.0F), Difference(t, 1), Difference(t, 3)));
}
HWY_INLINE Floats SecondRow7(const float* t) {
  return hn::MulAdd(Constant(2.0F),
                    Sum(t, 2),
                    hn::NegMulAdd(Constant(4.0F), Load(t), hn::Sub(Sum(t, 3), Sum(t, 1))));
}

// Where the energies of a filter go; null when it is not wanted.
HWY_INLINE float* OutputOf(const FilterPlan& plan, const FilterRowJob& job, Filter filter) {
  const int slot = plan.slot[static_cast<std::size_t>(filter)];
  return slot < 0 ? nullptr : job.energies + slot * kStripStride;
}

// Stores r² or |r| of a one-component filter.
template <class Response>
HWY_INLINE void StoreEnergies(const FilterPlan& plan,
                              int count,
                              float* out,
                              const Response& response) {
  if (out == nullptr) return;
  if (plan.energy == Energy::kAbs) {
    for (std::ptrdiff_t x = 0; x < count; x += NumLanes()) Store(hn::Abs(response(x)), out + x);
  } else {
    for (std::ptrdiff_t x = 0; x < count; x += NumLanes()) {
      const Floats r = response(x);
      Store(hn::Mul(r, r), out + x);
    }
  }
}

// Stores rx² + ry² or its root.
template <class ResponseX, class ResponseY>
HWY_INLINE void StoreGradientEnergies(const FilterPlan& plan,
                                      int count,
                                      float* out,
                                      const ResponseX& response_x,
                                      const ResponseY& response_y) {
  if (out == nullptr) return;
  const bool root = plan.energy == Energy::kAbs;
  for (std::ptrdiff_t x = 0; x < count; x += NumLanes()) {
    const Floats rx = response_x(x);
    const Floats ry = response_y(x);
    const Floats energy = hn::MulAdd(rx, rx, hn::Mul(ry, ry));
    Store(root ? hn::Sqrt(energy) : energy, out + x);
  }
}

HWY_INLINE void LawsEnergies(const FilterPlan& plan, const FilterRowJob& job) {
  for (int column = 0; column < 3; ++column) {
    const float* t = ScratchOf(job, static_cast<ScratchRow>(kLawsL + column)) + kReach;
    const auto out = [&](int row) {
      return OutputOf(plan, job, static_cast<Filter>(3 * column + row));
    };
    const auto level = [t](std::ptrdiff_t x) HWY_ATTR { return LawsRow(t + x, 0); };
    const auto edge = [t](std::ptrdiff_t x) HWY_ATTR { return LawsRow(t + x, 1); };
    const auto spot = [t](std::ptrdiff_t x) HWY_ATTR { return LawsRow(t + x, 2); };
    StoreEnergies(plan, job.count, out(0), level);
    StoreEnergies(plan, job.count, out(1), edge);
    StoreEnergies(plan, job.count, out(2), spot);
  }
}

// Two masks that are mirror images: responses even + odd and even − odd.
template <class Even, class Odd>
HWY_INLINE void StoreMirrorPair(const FilterPlan& plan,
                                const FilterRowJob& job,
                                Filter first,
                                Filter second,
                                const Even& even,
                                const Odd& odd) {
  float* out1 = OutputOf(plan, job, first);
  float* out2 = OutputOf(plan, job, second);
  if (out1 == nullptr && out2 == nullptr) return;
  if (out1 == nullptr) out1 = ScratchOf(job, kUnwanted1);
  if (out2 == nullptr) out2 = ScratchOf(job, kUnwanted2);
  const bool absolute = plan.energy == Energy::kAbs;
  for (std::ptrdiff_t x = 0; x < job.count; x += NumLanes()) {
    const Floats e = even(x);
    const Floats o = odd(x);
    const Floats r1 = hn::Add(e, o);
    const Floats r2 = hn::Sub(e, o);
    Store(absolute ? hn::Abs(r1) : hn::Mul(r1, r1), out1 + x);
    Store(absolute ? hn::Abs(r2) : hn::Mul(r2, r2), out2 + x);
  }
}

HWY_INLINE void EdgeEnergies(const FilterPlan& plan, const FilterRowJob& job) {
  const auto row = [&](ScratchRow name) { return ScratchOf(job, name) + kReach; };
  const float* box = row(kBox);
  const float* odd1 = row(kOdd1);
  const float* centre = row(kEvenCentre);
  const float* even1 = row(kEven1);
  const float* flat0 = row(kFlat0);
  const float* flat1 = row(kFlat1);
  const float* flat2 = row(kFlat2);
  const float* slope1 = row(kSlope1);
  const float* slope2 = row(kSlope2);
  StoreEnergies(
      plan, job.count, OutputOf(plan, job, Filter::kEdge0), [=](std::ptrdiff_t x) HWY_ATTR {
        return hn::Add(Difference(box + x, 1), Difference(box + x, 2));
      });
  StoreEnergies(
      plan, job.count, OutputOf(plan, job, Filter::kEdge90), [=](std::ptrdiff_t x) HWY_ATTR {
        return hn::Add(hn::Add(Sum(flat0 + x, 1), Sum(flat0 + x, 2)), Load(flat0 + x));
      });
  StoreMirrorPair(
      plan,
      job,
      Filter::kEdge30,
      Filter::kEdge150,
      [=](std::ptrdiff_t x) HWY_ATTR { return hn::Add(Load(centre + x), Sum(even1 + x, 1)); },
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Neg(hn::Add(Difference(box + x, 2), Difference(odd1 + x, 1))); });
  StoreMirrorPair(
      plan,
      job,
      Filter::kEdge60,
      Filter::kEdge120,
      [=](std::ptrdiff_t x) HWY_ATTR {
        return hn::Add(hn::Add(Sum(flat2 + x, 2), Sum(flat1 + x, 1)), Load(flat0 + x));
      },
      [=](std::ptrdiff_t x) HWY_ATTR {
        return hn::Neg(hn::Add(Difference(slope2 + x, 2), Difference(slope1 + x, 1)));
      });
}

// The horizontal factor's power of two: 1/8 or 1/4 on ∂x, the smoothing's 1/16 on ∂y; and so on.
HWY_INLINE void Sobel5Energies(const FilterPlan& plan, const FilterRowJob& job) {
  const auto row = [&](ScratchRow name) { return ScratchOf(job, name) + kReach; };
  const float* smooth5 = row(kSmooth5);
  const float* first5 = row(kFirst5);
  const float* second5 = row(kSecond5);
  StoreGradientEnergies(
      plan,
      job.count,
      OutputOf(plan, job, Filter::kSobelFirst5),
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 8), FirstRow5(smooth5 + x)); },
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 16), SmoothRow5(first5 + x)); });
  StoreGradientEnergies(
      plan,
      job.count,
      OutputOf(plan, job, Filter::kSobelSecond5),
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 4), SecondRow5(smooth5 + x)); },
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 16), SmoothRow5(second5 + x)); });
}

HWY_INLINE void Sobel7Energies(const FilterPlan& plan, const FilterRowJob& job) {
  const auto row = [&](ScratchRow name) { return ScratchOf(job, name) + kReach; };
  const float* smooth7 = row(kSmooth7);
  const float* first7 = row(kFirst7);
  const float* second7 = row(kSecond7);
  StoreGradientEnergies(
      plan,
      job.count,
      OutputOf(plan, job, Filter::kSobelFirst7),
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 32), FirstRow7(smooth7 + x)); },
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 64), SmoothRow7(first7 + x)); });
  StoreGradientEnergies(
      plan,
      job.count,
      OutputOf(plan, job, Filter::kSobelSecond7),
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 16), SecondRow7(smooth7 + x)); },
      [=](std::ptrdiff_t x)
          HWY_ATTR { return hn::Mul(Constant(1.0F / 64), SmoothRow7(second7 + x)); });
}

HWY_INLINE void LaplacianEnergies(const FilterPlan& plan, const FilterRowJob& job) {
  const float* up = job.y_rows[2];
  const float* centre = job.y_rows[3];
  const float* down = job.y_rows[4];
  StoreEnergies(
      plan, job.count, OutputOf(plan, job, Filter::kLaplacian), [=](std::ptrdiff_t x) HWY_ATTR {
        const Floats around = hn::Add(hn::Add(Load(up + x), Load(down + x)), Sum(centre + x, 1));
        return hn::NegMulAdd(Constant(4.0F), Load(centre + x), around);
      });
}

HWY_INLINE void ChromaEnergies(const FilterPlan& plan,
                               const FilterRowJob& job,
                               Filter filter,
                               const std::array<const float*, 3>& rows) {
  const auto level = [&](int row, std::ptrdiff_t x)
                         HWY_ATTR { return LawsRow(rows[static_cast<std::size_t>(row)] + x, 0); };
  StoreEnergies(plan, job.count, OutputOf(plan, job, filter), [&](std::ptrdiff_t x) HWY_ATTR {
    return hn::MulAdd(Constant(2.0F), level(1, x), hn::Add(level(0, x), level(2, x)));
  });
}

// ln(E + kLogEnergyOffset) in place of E.
HWY_INLINE void LogEnergies(const FilterPlan& plan, const FilterRowJob& job) {
  const Floats offset = Constant(kLogEnergyOffset);
  for (int filter = 0; filter < plan.num_filters; ++filter) {
    float* row = job.energies + filter * kStripStride;
    for (std::ptrdiff_t x = 0; x < job.count; x += NumLanes()) {
      Store(NaturalLog(hn::Add(Load(row + x), offset)), row + x);
    }
  }
}

inline void FilterRow(const FilterPlan& plan, const FilterRowJob& job) {
  if (plan.laws) {
    LawsColumns(job);
    LawsEnergies(plan, job);
  }
  if (plan.edges) {
    EdgeColumns(job);
    EdgeEnergies(plan, job);
  }
  if (plan.sobel5) {
    Sobel5Columns(job);
    Sobel5Energies(plan, job);
  }
  if (plan.sobel7) {
    Sobel7Columns(job);
    Sobel7Energies(plan, job);
  }
  LaplacianEnergies(plan, job);
  if (plan.chroma) {
    ChromaEnergies(plan, job, Filter::kChromaBlueLL, job.cb_rows);
    ChromaEnergies(plan, job, Filter::kChromaRedLL, job.cr_rows);
  }
  if (plan.energy == Energy::kLog) LogEnergies(plan, job);
}

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::features::internal
HWY_AFTER_NAMESPACE();

#endif  // HANDCRAFT_FILTER_ROW_INL_H_
