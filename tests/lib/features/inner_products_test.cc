// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/inner_products.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lib/core/rng.h"

namespace handcraft::features {
namespace {

// num_rows rows of num_features numbers in −1 … 1, filled up with zeros.
template <class T>
std::vector<T> DrawRows(std::size_t num_rows, std::size_t num_features, std::uint64_t seed) {
  Rng rng(seed);
  const std::size_t stride = PaddedLength(num_features);
  std::vector<T> rows(num_rows * stride, T{0});
  for (std::size_t i = 0; i < num_rows; ++i) {
    for (std::size_t j = 0; j < num_features; ++j) {
      rows[i * stride + j] = static_cast<T>(2.0 * rng.Uniform() - 1.0);
    }
  }
  return rows;
}

// The header's sum, written out.
template <class T>
double PartialSums(const T* a, const T* b, std::size_t stride) {
  double s[8] = {};
  for (std::size_t j = 0; j < stride; ++j) {
    s[j % 8] = std::fma(static_cast<double>(a[j]), static_cast<double>(b[j]), s[j % 8]);
  }
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

bool HasFusedMultiplyAdd(InstructionSet set) {
  return set == InstructionSet::kNeon || set == InstructionSet::kAvx2 ||
         set == InstructionSet::kAvx512;
}

TEST(InnerProducts, ByHand) {
  const std::vector<float> rows = {1, 2, 3, 0, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0, 0, 0};
  const std::vector<float> x = {4, 5, 6, 0, 0, 0, 0, 0};
  std::vector<double> products(2);
  InnerProducts(PaddedRows<float>{rows.data(), 2, 8}, x.data(), products);
  EXPECT_EQ(products, (std::vector<double>{32.0, 2.0}));
}

TEST(InnerProducts, PadsToWholeVectors) {
  EXPECT_EQ(PaddedLength(0), 0U);
  EXPECT_EQ(PaddedLength(1), 8U);
  EXPECT_EQ(PaddedLength(8), 8U);
  EXPECT_EQ(PaddedLength(7500), 7504U);
}

TEST(InnerProducts, EverySetOfInstructionsAddsFloatsAlike) {
  for (const std::size_t num_features : {1U, 8U, 37U, 200U}) {
    for (const std::size_t num_rows : {0U, 1U, 3U, 7U, 8U, 21U}) {
      const std::vector<float> rows = DrawRows<float>(num_rows, num_features, 1);
      const std::vector<float> x = DrawRows<float>(1, num_features, 2);
      const std::size_t stride = PaddedLength(num_features);
      for (const InstructionSet set : SupportedInstructionSets()) {
        std::vector<double> products(num_rows);
        InnerProducts(PaddedRows<float>{rows.data(), num_rows, stride}, x.data(), products, set);
        for (std::size_t i = 0; i < num_rows; ++i) {
          EXPECT_EQ(
              std::bit_cast<std::uint64_t>(products[i]),
              std::bit_cast<std::uint64_t>(PartialSums(rows.data() + i * stride, x.data(), stride)))
              << NameOf(set) << ", row " << i << " of " << num_rows << ", " << num_features;
        }
      }
    }
  }
}

TEST(InnerProducts, DoublesAreTheSameBitsWhereMultiplyAddsAreFused) {
  constexpr std::size_t kNumFeatures = 61;
  const std::size_t stride = PaddedLength(kNumFeatures);
  const std::vector<double> rows = DrawRows<double>(11, kNumFeatures, 3);
  const std::vector<double> x = DrawRows<double>(1, kNumFeatures, 4);
  for (const InstructionSet set : SupportedInstructionSets()) {
    std::vector<double> products(11);
    InnerProducts(PaddedRows<double>{rows.data(), 11, stride}, x.data(), products, set);
    for (std::size_t i = 0; i < products.size(); ++i) {
      const double expected = PartialSums(rows.data() + i * stride, x.data(), stride);
      // Without it, each of 61 products is rounded once more.
      EXPECT_NEAR(products[i], expected, HasFusedMultiplyAdd(set) ? 0.0 : 61 * 1.2e-16)
          << NameOf(set);
    }
  }
}

TEST(InnerProductTable, HoldsTheSameBitsAsProductsOfAVector) {
  constexpr std::size_t kNumFeatures = 45;
  const std::size_t stride = PaddedLength(kNumFeatures);
  for (const std::size_t num_rows : {1U, 2U, 4U, 9U}) {
    for (const std::size_t num_columns : {1U, 3U, 8U, 10U}) {
      const std::vector<double> a = DrawRows<double>(num_rows, kNumFeatures, 5);
      const std::vector<double> b = DrawRows<double>(num_columns, kNumFeatures, 6);
      const std::size_t product_stride = num_columns + 2;
      for (const InstructionSet set : SupportedInstructionSets()) {
        std::vector<double> table(num_rows * product_stride, -7.0);
        InnerProductTable({a.data(), num_rows, stride},
                          {b.data(), num_columns, stride},
                          table.data(),
                          product_stride,
                          set);
        for (std::size_t i = 0; i < num_rows; ++i) {
          std::vector<double> expected(num_columns);
          InnerProducts(PaddedRows<double>{b.data(), num_columns, stride},
                        a.data() + i * stride,
                        expected,
                        set);
          for (std::size_t k = 0; k < num_columns; ++k) {
            EXPECT_EQ(table[i * product_stride + k], expected[k]) << NameOf(set);
          }
          EXPECT_EQ(table[i * product_stride + num_columns], -7.0) << "wrote past the row";
        }
      }
    }
  }
}

TEST(InnerProducts, FloatsAndTheSameNumbersAsDoublesGiveTheSameBits) {
  const std::vector<float> rows = DrawRows<float>(5, 100, 7);
  const std::vector<float> x = DrawRows<float>(1, 100, 8);
  const std::vector<double> wide_rows(rows.begin(), rows.end());
  const std::vector<double> wide_x(x.begin(), x.end());
  std::vector<double> products(5);
  std::vector<double> wide_products(5);
  InnerProducts(PaddedRows<float>{rows.data(), 5, PaddedLength(100)}, x.data(), products);
  InnerProducts(
      PaddedRows<double>{wide_rows.data(), 5, PaddedLength(100)}, wide_x.data(), wide_products);
  EXPECT_EQ(products, wide_products);
}

}  // namespace
}  // namespace handcraft::features
