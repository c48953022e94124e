// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/inner_products.h"

// Highway's headers compile this file once for each instruction set; its library, which would
// choose among them, is not used, so that the runtime depends on nothing (docs/decisions).
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)
#define HWY_IS_DEBUG_BUILD 0
#define HWY_TARGET_INCLUDE "lib/features/inner_products.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

// Once, before the first instruction set.
#ifndef HANDCRAFT_INNER_PRODUCTS_ONCE_
#define HANDCRAFT_INNER_PRODUCTS_ONCE_
namespace handcraft::features::internal {

struct InnerProductKernels {
  void (*of_floats)(const PaddedRows<float>& rows, const float* x, double* products);
  void (*of_doubles)(const PaddedRows<double>& rows, const double* x, double* products);
};
// Apart, so that the linker can leave it out of the robot's library, which has no use for it.
struct TableKernel {
  void (*table)(const PaddedRows<double>& a,
                const PaddedRows<double>& b,
                double* products,
                std::size_t product_stride);
};

}  // namespace handcraft::features::internal
#endif

HWY_BEFORE_NAMESPACE();
namespace handcraft::features {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using DoubleTag = hn::CappedTag<double, kInnerProductLanes>;
using Doubles = hn::Vec<DoubleTag>;
constexpr std::size_t kWidth = hn::MaxLanes(DoubleTag());
constexpr std::size_t kVectors = kInnerProductLanes / kWidth;  // that hold the eight partial sums

HWY_INLINE Doubles Load(const double* p) { return hn::LoadU(DoubleTag(), p); }
HWY_INLINE Doubles Load(const float* p) {
  const hn::Rebind<float, DoubleTag> float_tag;
  return hn::PromoteTo(DoubleTag(), hn::LoadU(float_tag, p));
}

HWY_INLINE double AddPartialSums(const Doubles (&sums)[kVectors]) {
  double s[kInnerProductLanes];
  for (std::size_t v = 0; v < kVectors; ++v) hn::StoreU(sums[v], DoubleTag(), s + v * kWidth);
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

// A tile of kRows by kColumns products: their sums stay in registers.
template <std::size_t kRows, std::size_t kColumns, class T>
HWY_INLINE void Tile(
    const T* a, const T* b, std::size_t stride, double* products, std::size_t product_stride) {
  Doubles sums[kRows][kColumns][kVectors];
  for (std::size_t i = 0; i < kRows; ++i) {
    for (std::size_t k = 0; k < kColumns; ++k) {
      for (std::size_t v = 0; v < kVectors; ++v) sums[i][k][v] = hn::Zero(DoubleTag());
    }
  }
  for (std::size_t j = 0; j < stride; j += kInnerProductLanes) {
    HWY_UNROLL(8)
    for (std::size_t v = 0; v < kVectors; ++v) {
      Doubles columns[kColumns];
      HWY_UNROLL(8)
      for (std::size_t k = 0; k < kColumns; ++k) columns[k] = Load(b + k * stride + j + v * kWidth);
      HWY_UNROLL(8)
      for (std::size_t i = 0; i < kRows; ++i) {
        const Doubles row = Load(a + i * stride + j + v * kWidth);
        HWY_UNROLL(8)
        for (std::size_t k = 0; k < kColumns; ++k) {
          sums[i][k][v] = hn::MulAdd(row, columns[k], sums[i][k][v]);
        }
      }
    }
  }
  for (std::size_t i = 0; i < kRows; ++i) {
    for (std::size_t k = 0; k < kColumns; ++k) {
      products[i * product_stride + k] = AddPartialSums(sums[i][k]);
    }
  }
}

// Eight chains of multiply-adds hide their latency: 8 rows of 512 bits, 4 of 256, 2 of 128.
constexpr std::size_t kRowsAtOnce = kVectors >= 8 ? 1 : 8 / kVectors;

template <class T>
HWY_INLINE void TimesVector(const PaddedRows<T>& rows, const T* x, double* products) {
  std::size_t i = 0;
  for (; i + kRowsAtOnce <= rows.num_rows; i += kRowsAtOnce) {
    Tile<kRowsAtOnce, 1>(rows.Row(i), x, rows.stride, products + i, 1);
  }
  for (; i < rows.num_rows; ++i) Tile<1, 1>(rows.Row(i), x, rows.stride, products + i, 1);
}

void OfFloats(const PaddedRows<float>& rows, const float* x, double* products) {
  TimesVector(rows, x, products);
}

void OfDoubles(const PaddedRows<double>& rows, const double* x, double* products) {
  TimesVector(rows, x, products);
}

// 4 × 4 sums fit thirty-two registers of 512 bits, 2 × 2 of two or four vectors the others.
constexpr std::size_t kSide = kVectors == 1 ? 4 : kVectors <= 4 ? 2 : 1;

template <std::size_t kRows>
HWY_INLINE void TableRows(const double* a,
                          const PaddedRows<double>& b,
                          double* products,
                          std::size_t product_stride) {
  std::size_t k = 0;
  for (; k + kSide <= b.num_rows; k += kSide) {
    Tile<kRows, kSide>(a, b.Row(k), b.stride, products + k, product_stride);
  }
  for (; k < b.num_rows; ++k) {
    Tile<kRows, 1>(a, b.Row(k), b.stride, products + k, product_stride);
  }
}

void Table(const PaddedRows<double>& a,
           const PaddedRows<double>& b,
           double* products,
           std::size_t product_stride) {
  std::size_t i = 0;
  for (; i + kSide <= a.num_rows; i += kSide) {
    TableRows<kSide>(a.Row(i), b, products + i * product_stride, product_stride);
  }
  for (; i < a.num_rows; ++i) {
    TableRows<1>(a.Row(i), b, products + i * product_stride, product_stride);
  }
}

}  // namespace

// Not inline: tables of each instruction set, found by name below.
extern const internal::InnerProductKernels kInnerProductKernels;
const internal::InnerProductKernels kInnerProductKernels = {&OfFloats, &OfDoubles};
extern const internal::TableKernel kTableKernel;
const internal::TableKernel kTableKernel = {&Table};

}  // namespace HWY_NAMESPACE
}  // namespace handcraft::features
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace handcraft::features {
namespace {

// What the code of an instruction set has under this name; one that this program has no code for
// gives the baseline.
#if HWY_TARGETS & HWY_AVX3
#define HANDCRAFT_CASE_AVX3(name) \
  case InstructionSet::kAvx512:   \
    return N_AVX3::name;
#else
#define HANDCRAFT_CASE_AVX3(name)
#endif
#if HWY_TARGETS & HWY_AVX2
#define HANDCRAFT_CASE_AVX2(name) \
  case InstructionSet::kAvx2:     \
    return N_AVX2::name;
#else
#define HANDCRAFT_CASE_AVX2(name)
#endif
#if HWY_TARGETS & HWY_SSE4
#define HANDCRAFT_CASE_SSE4(name) \
  case InstructionSet::kSse4:     \
    return N_SSE4::name;
#else
#define HANDCRAFT_CASE_SSE4(name)
#endif
#define HANDCRAFT_DISPATCH(set, name)   \
  switch (set) {                        \
    HANDCRAFT_CASE_AVX3(name)           \
    HANDCRAFT_CASE_AVX2(name)           \
    HANDCRAFT_CASE_SSE4(name)           \
    default:                            \
      return HWY_STATIC_DISPATCH(name); \
  }

const internal::InnerProductKernels& KernelsFor(InstructionSet set) noexcept {
  HANDCRAFT_DISPATCH(set, kInnerProductKernels)
}

const internal::TableKernel& TableKernelFor(InstructionSet set) noexcept {
  HANDCRAFT_DISPATCH(set, kTableKernel)
}

}  // namespace

void InnerProducts(const PaddedRows<float>& rows,
                   const float* x,
                   std::span<double> products,
                   InstructionSet set) noexcept {
  KernelsFor(set).of_floats(rows, x, products.data());
}

void InnerProducts(const PaddedRows<double>& rows,
                   const double* x,
                   std::span<double> products,
                   InstructionSet set) noexcept {
  KernelsFor(set).of_doubles(rows, x, products.data());
}

void InnerProductTable(const PaddedRows<double>& a,
                       const PaddedRows<double>& b,
                       double* products,
                       std::size_t product_stride,
                       InstructionSet set) noexcept {
  TableKernelFor(set).table(a, b, products, product_stride);
}

}  // namespace handcraft::features
#endif  // HWY_ONCE
