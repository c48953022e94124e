// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// The vertical halves of all separable kernels for one row of pixels, a scratch row each, shared by
// filters with a common factor; compiled once for each instruction set. Masks: filter_bank.cc.

#if defined(HANDCRAFT_FILTER_COLUMNS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef HANDCRAFT_FILTER_COLUMNS_INL_H_
#undef HANDCRAFT_FILTER_COLUMNS_INL_H_
#else
#define HANDCRAFT_FILTER_COLUMNS_INL_H_
#endif

#include <cstddef>

#include <hwy/highway.h>

#include "lib/features/pixel_kernels.h"
#include "lib/features/vector_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace handcraft::features::internal {
namespace HWY_NAMESPACE {
// Scratch columns left and right of the energies: the reach of the 7-wide kernels, and one.
constexpr int kReach = 4;

enum ScratchRow : int {
  kLawsL,  // 1 2 1 down the column
  kLawsE,
  kLawsS,
  kBox,   // 1 1 1 1 1, times 0.05
  kOdd1,  // 0° part of the 30° mask at columns ±1
  kEvenCentre,
  kEven1,
  kFlat0,  // vertical difference for 90° and the centre of 60°, columns 0, ±1, ±2
  kFlat1,
  kFlat2,
  kSlope1,  // vertical average for the odd part of 60°, columns ±1, ±2
  kSlope2,
  kSmooth5,
  kFirst5,
  kSecond5,
  kSmooth7,
  kFirst7,
  kSecond7,
  kUnwanted1,  // where energies go that nobody asked for
  kUnwanted2,
};

HWY_INLINE float* ScratchOf(const FilterRowJob& job, ScratchRow row) {
  return job.scratch + row * kStripStride;
}

// Sums and differences of the rows above and below the centre.
struct Column {
  Floats centre, sum1, sum2, difference1, difference2;
};

HWY_INLINE Column LoadColumn(const FilterRowJob& job, std::ptrdiff_t x) {
  const Floats up1 = Load(job.y_rows[2] + x);
  const Floats down1 = Load(job.y_rows[4] + x);
  const Floats up2 = Load(job.y_rows[1] + x);
  const Floats down2 = Load(job.y_rows[5] + x);
  return {Load(job.y_rows[3] + x),
          hn::Add(up1, down1),
          hn::Add(up2, down2),
          hn::Sub(down1, up1),
          hn::Sub(down2, up2)};
}

// Vertical halves, for columns −kReach … count + kReach − 1; scratch row index = column + kReach.
HWY_INLINE void LawsColumns(const FilterRowJob& job) {
  const Floats two = Constant(2.0F);
  for (std::ptrdiff_t i = 0; i < job.count + 2 * kReach; i += NumLanes()) {
    const Floats up = Load(job.y_rows[2] + i - kReach);
    const Floats down = Load(job.y_rows[4] + i - kReach);
    const Floats centre = Load(job.y_rows[3] + i - kReach);
    const Floats sum = hn::Add(up, down);
    Store(hn::MulAdd(two, centre, sum), ScratchOf(job, kLawsL) + i);
    Store(hn::Sub(down, up), ScratchOf(job, kLawsE) + i);
    Store(hn::MulSub(two, centre, sum), ScratchOf(job, kLawsS) + i);
  }
}

// The 30° mask M: columns ±1, ±2 hold Q, B5 with opposite signs (odd), columns 0, ±1 the even rest;
// the 60° mask is −Mᵀ. Weights are hundredths, over 2000.
HWY_INLINE void EdgeColumns(const FilterRowJob& job) {
  const Floats scale = Constant(0.05F);
  for (std::ptrdiff_t i = 0; i < job.count + 2 * kReach; i += NumLanes()) {
    const Column c = LoadColumn(job, i - kReach);
    const auto put = [&](ScratchRow row, Floats value)
                         HWY_ATTR { Store(hn::Mul(scale, value), ScratchOf(job, row) + i); };
    put(kBox, hn::Add(hn::Add(c.sum1, c.sum2), c.centre));
    put(kOdd1, hn::MulAdd(Constant(0.34F), c.sum2, hn::MulAdd(Constant(0.89F), c.sum1, c.centre)));
    put(kEvenCentre, hn::MulAdd(Constant(0.92F), c.difference1, c.difference2));
    put(kEven1,
        hn::MulAdd(Constant(0.66F), c.difference2, hn::Mul(Constant(0.11F), c.difference1)));
    put(kFlat0, hn::Add(c.difference1, c.difference2));
    put(kFlat1, hn::MulAdd(Constant(0.89F), c.difference1, c.difference2));
    put(kFlat2, hn::MulAdd(Constant(0.34F), c.difference1, c.difference2));
    put(kSlope1, hn::MulAdd(Constant(0.11F), c.sum1, hn::Mul(Constant(0.92F), c.centre)));
    put(kSlope2, hn::MulAdd(Constant(0.66F), c.sum1, c.centre));
  }
}

// Each vertical factor carries half of the kernel's power of two (filter_bank.cc).
HWY_INLINE void Sobel5Columns(const FilterRowJob& job) {
  for (std::ptrdiff_t i = 0; i < job.count + 2 * kReach; i += NumLanes()) {
    const Column c = LoadColumn(job, i - kReach);
    const Floats smooth =
        hn::MulAdd(Constant(4.0F), c.sum1, hn::MulAdd(Constant(6.0F), c.centre, c.sum2));
    const Floats first = hn::MulAdd(Constant(2.0F), c.difference1, c.difference2);
    const Floats second = hn::NegMulAdd(Constant(2.0F), c.centre, c.sum2);
    Store(hn::Mul(Constant(1.0F / 16), smooth), ScratchOf(job, kSmooth5) + i);
    Store(hn::Mul(Constant(1.0F / 8), first), ScratchOf(job, kFirst5) + i);
    Store(hn::Mul(Constant(1.0F / 4), second), ScratchOf(job, kSecond5) + i);
  }
}

HWY_INLINE void Sobel7Columns(const FilterRowJob& job) {
  for (std::ptrdiff_t i = 0; i < job.count + 2 * kReach; i += NumLanes()) {
    const Column c = LoadColumn(job, i - kReach);
    const Floats up3 = Load(job.y_rows[0] + i - kReach);
    const Floats down3 = Load(job.y_rows[6] + i - kReach);
    const Floats sum3 = hn::Add(up3, down3);
    const Floats smooth = hn::MulAdd(
        Constant(6.0F),
        c.sum2,
        hn::MulAdd(Constant(15.0F), c.sum1, hn::MulAdd(Constant(20.0F), c.centre, sum3)));
    const Floats first = hn::MulAdd(Constant(4.0F),
                                    c.difference2,
                                    hn::MulAdd(Constant(5.0F), c.difference1, hn::Sub(down3, up3)));
    const Floats second = hn::MulAdd(
        Constant(2.0F), c.sum2, hn::NegMulAdd(Constant(4.0F), c.centre, hn::Sub(sum3, c.sum1)));
    Store(hn::Mul(Constant(1.0F / 64), smooth), ScratchOf(job, kSmooth7) + i);
    Store(hn::Mul(Constant(1.0F / 32), first), ScratchOf(job, kFirst7) + i);
    Store(hn::Mul(Constant(1.0F / 16), second), ScratchOf(job, kSecond7) + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::features::internal
HWY_AFTER_NAMESPACE();

#endif  // HANDCRAFT_FILTER_COLUMNS_INL_H_
