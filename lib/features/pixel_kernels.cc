// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/pixel_kernels.h"

// Highway's headers compile this file once for each instruction set; its library, which would
// choose among them, is not used, so that the runtime depends on nothing (docs/decisions).
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#define HWY_IS_DEBUG_BUILD 0
#define HWY_TARGET_INCLUDE "lib/features/pixel_kernels.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lib/features/filter_row-inl.h"

HWY_BEFORE_NAMESPACE();
namespace handcraft::features::internal {
namespace HWY_NAMESPACE {

// ITU-R BT.601 in the fixed-point numbers of colour.cc. Every value stays below 2^24, so single
// precision holds it exactly, and the shift rounds as the integer code does.
template <class Bytes>
HWY_INLINE Floats ToFloats(Bytes bytes) {
  const hn::RebindToSigned<FloatTag> int_tag;
  return hn::ConvertTo(FloatTag(), hn::PromoteTo(int_tag, bytes));
}

HWY_INLINE Floats ShiftDown(Floats fixed_point) {
  const hn::RebindToSigned<FloatTag> int_tag;
  const Floats value =
      hn::ConvertTo(FloatTag(), hn::ShiftRight<14>(hn::ConvertTo(int_tag, fixed_point)));
  return hn::Min(value, Constant(255.0F));
}

HWY_INLINE void ConvertBlock(
    const std::uint8_t* pixels, PixelFormat format, float* y, float* cb, float* cr) {
  const hn::Rebind<std::uint8_t, FloatTag> byte_tag;
  const Floats to_unit = Constant(1.0F / 255.0F);
  if (format == PixelFormat::kGray8) {
    Store(hn::Mul(to_unit, ToFloats(hn::LoadU(byte_tag, pixels))), y);
    return;
  }
  hn::Vec<decltype(byte_tag)> first, second, third;
  hn::LoadInterleaved3(byte_tag, pixels, first, second, third);
  const bool is_rgb = format == PixelFormat::kRgb8;
  const Floats r = ToFloats(is_rgb ? first : third);
  const Floats g = ToFloats(second);
  const Floats b = ToFloats(is_rgb ? third : first);
  const Floats half = Constant(8192.0F);
  const Floats luma = ShiftDown(
      hn::MulAdd(Constant(4899.0F),
                 r,
                 hn::MulAdd(Constant(9617.0F), g, hn::MulAdd(Constant(1868.0F), b, half))));
  Store(hn::Mul(to_unit, luma), y);
  if (cb == nullptr) return;
  const Floats offset = Constant(128.0F * 16384.0F + 8192.0F);
  const Floats blue = ShiftDown(hn::MulAdd(Constant(9241.0F), hn::Sub(b, luma), offset));
  const Floats red = ShiftDown(hn::MulAdd(Constant(11682.0F), hn::Sub(r, luma), offset));
  Store(hn::Mul(to_unit, blue), cb);
  Store(hn::Mul(to_unit, red), cr);
}

void ConvertRow(
    const std::uint8_t* pixels, PixelFormat format, int count, float* y, float* cb, float* cr) {
  const int channels = NumChannels(format);
  const int lanes = NumLanes();
  std::ptrdiff_t x = 0;
  for (; x + lanes <= count; x += lanes) {
    ConvertBlock(pixels + x * channels,
                 format,
                 y + x,
                 cb == nullptr ? nullptr : cb + x,
                 cr == nullptr ? nullptr : cr + x);
  }
  if (x == count) return;
  std::uint8_t last[3 * HWY_MAX_BYTES] = {};
  const std::ptrdiff_t num_bytes = (count - x) * channels;
  for (std::ptrdiff_t i = 0; i < num_bytes; ++i) last[i] = pixels[x * channels + i];
  ConvertBlock(
      last, format, y + x, cb == nullptr ? nullptr : cb + x, cr == nullptr ? nullptr : cr + x);
}

// A block of kBlocks vectors of pixels by kWindow rows of sums stays in registers while all filters
// and columns of the window pass: kBlocks loads of energies feed kBlocks · kWindow multiply-adds.
template <int kWindow, int kBlocks>
HWY_INLINE void CorrelateBlock(const CorrelateRowJob& job, std::ptrdiff_t x) {
  const std::ptrdiff_t lanes = NumLanes();
  Floats sums[kWindow][kBlocks];
  HWY_UNROLL(5)
  for (int j = 0; j < kWindow; ++j) {
    HWY_UNROLL(4)
    for (int k = 0; k < kBlocks; ++k)
      sums[j][k] = Load(job.sums[static_cast<std::size_t>(j)] + x + k * lanes);
  }
  const float* weights = job.weights;
  const float* energies = job.energies + kMaxRadius - kWindow / 2 + x;
  for (int filter = 0; filter < job.num_filters; ++filter, energies += kStripStride) {
    HWY_UNROLL(5)
    for (int i = 0; i < kWindow; ++i, weights += kWindow) {
      Floats e[kBlocks];
      HWY_UNROLL(4)
      for (int k = 0; k < kBlocks; ++k) e[k] = Load(energies + i + k * lanes);
      HWY_UNROLL(5)
      for (int j = 0; j < kWindow; ++j) {
        const Floats weight = Constant(weights[j]);
        HWY_UNROLL(4)
        for (int k = 0; k < kBlocks; ++k) sums[j][k] = hn::MulAdd(weight, e[k], sums[j][k]);
      }
    }
  }
  HWY_UNROLL(5)
  for (int j = 0; j < kWindow; ++j) {
    HWY_UNROLL(4)
    for (int k = 0; k < kBlocks; ++k)
      Store(sums[j][k], job.sums[static_cast<std::size_t>(j)] + x + k * lanes);
  }
}

template <int kWindow, int kBlocks>
HWY_INLINE void CorrelateWindow(const CorrelateRowJob& job) {
  const std::ptrdiff_t block = std::ptrdiff_t{kBlocks} * NumLanes();
  std::ptrdiff_t x = 0;
  for (; x + block <= job.count; x += block) CorrelateBlock<kWindow, kBlocks>(job, x);
  for (; x < job.count; x += NumLanes()) CorrelateBlock<kWindow, 1>(job, x);
}

// Sixteen registers hold 2 × 5 or 3 × 3 sums, thirty-two hold 4 × 5.
constexpr bool kManyRegisters = HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON;

void CorrelateRow(const CorrelateRowJob& job) {
  switch (job.window) {
    case 1:
      return CorrelateWindow<1, 4>(job);
    case 3:
      return CorrelateWindow < 3, kManyRegisters ? 4 : 3 > (job);
    default:
      return CorrelateWindow < 5, kManyRegisters ? 4 : 2 > (job);
  }
}

void SigmoidRow(float* values, int count) {
  for (std::ptrdiff_t x = 0; x < count; x += NumLanes())
    Store(Sigmoid(Load(values + x)), values + x);
}

// Not inline: one table an instruction set, found by name below.
extern const PixelKernels kPixelKernels;
const PixelKernels kPixelKernels = {&ConvertRow, &FilterRow, &CorrelateRow, &SigmoidRow};

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::features::internal
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace handcraft::features::internal {

FilterPlan::FilterPlan(const FeatureSpec& spec) noexcept : energy(spec.energy) {
  slot.fill(-1);
  for (const Filter filter : spec.filters) {
    const auto number = static_cast<std::size_t>(filter);
    slot[number] = num_filters++;
    laws |= filter <= Filter::kLawsSS;
    edges |= filter >= Filter::kEdge0 && filter <= Filter::kEdge150;
    sobel5 |= filter == Filter::kSobelFirst5 || filter == Filter::kSobelSecond5;
    sobel7 |= filter == Filter::kSobelFirst7 || filter == Filter::kSobelSecond7;
    chroma |= filter >= Filter::kChromaBlueLL;
  }
}

const PixelKernels& KernelsFor(InstructionSet set) noexcept {
  switch (set) {
#if HWY_TARGETS & HWY_AVX3
    case InstructionSet::kAvx512:
      return N_AVX3::kPixelKernels;
#endif
#if HWY_TARGETS & HWY_AVX2
    case InstructionSet::kAvx2:
      return N_AVX2::kPixelKernels;
#endif
#if HWY_TARGETS & HWY_SSE4
    case InstructionSet::kSse4:
      return N_SSE4::kPixelKernels;
#endif
    default:
      return HWY_STATIC_DISPATCH(kPixelKernels);
  }
}

}  // namespace handcraft::features::internal
#endif  // HWY_ONCE
