// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <span>

#include "lib/features/instruction_set.h"

namespace handcraft::features {

/// Rows of numbers for inner products are filled up with zeros to a multiple of this length.
inline constexpr std::size_t kInnerProductLanes = 8;

[[nodiscard]] constexpr std::size_t PaddedLength(std::size_t num_features) noexcept {
  return (num_features + kInnerProductLanes - 1) / kInnerProductLanes * kInnerProductLanes;
}

/// Rows of `stride` numbers each, one after another, stride a multiple of kInnerProductLanes.
template <class T>
struct PaddedRows {
  const T* data = nullptr;
  std::size_t num_rows = 0;
  std::size_t stride = 0;

  [[nodiscard]] const T* Row(std::size_t i) const noexcept { return data + i * stride; }
};

/// products[i] = Σ_j rows[i, j] · x[j], summed in double: `x` is rows.stride long, `products`
/// rows.num_rows.
///
/// Every product is the sum of eight partial sums (of the features j ≡ 0 … 7 modulo 8, from front
/// to back), added as ((0 + 4) + (2 + 6)) + ((1 + 5) + (3 + 7)), whichever instructions do it and
/// wherever the row stands: the same two rows give the same bits in a product of a vector and in
/// one of matrices, with every set of instructions that has a fused multiply-add; of floats with
/// every set, since products of floats are exact in double. Does not allocate; thread-safe.
void InnerProducts(const PaddedRows<float>& rows,
                   const float* x,
                   std::span<double> products,
                   InstructionSet set = SupportedInstructionSets().back()) noexcept;
void InnerProducts(const PaddedRows<double>& rows,
                   const double* x,
                   std::span<double> products,
                   InstructionSet set = SupportedInstructionSets().back()) noexcept;

/// products[i · product_stride + k] = Σ_j a[i, j] · b[k, j], the same sums as above. Each tile of
/// rows stays in registers while the features pass; b should fit the second-level cache.
void InnerProductTable(const PaddedRows<double>& a,
                       const PaddedRows<double>& b,
                       double* products,
                       std::size_t product_stride,
                       InstructionSet set = SupportedInstructionSets().back()) noexcept;

}  // namespace handcraft::features
