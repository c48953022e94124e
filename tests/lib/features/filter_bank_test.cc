// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/filter_bank.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

namespace handcraft::features {
namespace {

double SumOf(const Kernel& kernel) {
  double sum = 0.0;
  for (const auto& row : kernel) {
    for (const float weight : row) sum += weight;
  }
  return sum;
}

double SumOfAbsolutes(const Kernel& kernel) {
  double sum = 0.0;
  for (const auto& row : kernel) {
    for (const float weight : row) sum += std::abs(weight);
  }
  return sum;
}

const Kernel& First(const FilterKernels& kernels) { return kernels.components[0]; }

TEST(FilterBank, LawsMasksAreOuterProducts) {
  const FilterKernels edge_spot = KernelsOf(Filter::kLawsES);  // column E, row S
  const float column[3] = {-1, 0, 1};
  const float row[3] = {-1, 2, -1};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      EXPECT_EQ(First(edge_spot)[i + 2][j + 2], column[i] * row[j]);
  }
  EXPECT_EQ(SumOf(First(KernelsOf(Filter::kLawsLL))), 16.0);
}

// Facts about the Nevatia-Babu masks: they sum to 0; Σ|w| is 2000 for 0° and 90°, else 2204 (over
// 2000 here); the gradient directions are 0, 23.2, 66.8, 90, 113.2 and 156.8 degrees.
TEST(FilterBank, EdgeMasksHaveThePublishedSizesAndDirections) {
  const double sizes[6] = {2000, 2204, 2204, 2000, 2204, 2204};
  const double directions_deg[6] = {0, 23.2, 66.8, 90, 113.2, 156.8};
  for (int index = 0; index < 6; ++index) {
    const auto filter = static_cast<Filter>(static_cast<int>(Filter::kEdge0) + index);
    const FilterKernels kernels = KernelsOf(filter);
    const Kernel& kernel = First(kernels);
    EXPECT_NEAR(SumOf(kernel), 0.0, 1e-7) << NameOf(filter);
    EXPECT_NEAR(SumOfAbsolutes(kernel), sizes[index] / 2000.0, 1e-6) << NameOf(filter);
    double gx = 0.0;
    double gy = 0.0;  // up
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t j = 0; j < 7; ++j) {
        gx += static_cast<double>(kernel[i][j]) * (static_cast<double>(j) - 3.0);
        gy -= static_cast<double>(kernel[i][j]) * (static_cast<double>(i) - 3.0);
      }
    }
    double direction = std::atan2(gy, gx) * 180.0 / 3.14159265358979;
    direction = std::fmod(direction + 180.0 + 1e-6, 180.0);
    EXPECT_NEAR(direction, directions_deg[index], 0.05) << NameOf(filter);
  }
}

TEST(FilterBank, Edge30IsThePrintedMask) {
  const float printed[5][5] = {{-100, 32, 100, 100, 100},
                               {-100, -78, 92, 100, 100},
                               {-100, -100, 0, 100, 100},
                               {-100, -100, -92, 78, 100},
                               {-100, -100, -100, -32, 100}};
  const FilterKernels kernels = KernelsOf(Filter::kEdge30);
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < 5; ++j) {
      EXPECT_EQ(First(kernels)[i + 1][j + 1], printed[i][j] / 2000.0F);
    }
  }
}

TEST(FilterBank, OnlySobelChannelsHaveTwoComponents) {
  for (int i = 0; i < kNumFilters; ++i) {
    const auto filter = static_cast<Filter>(i);
    const bool is_sobel = filter >= Filter::kSobelFirst5 && filter <= Filter::kSobelSecond7;
    EXPECT_EQ(KernelsOf(filter).num_components, is_sobel ? 2 : 1) << NameOf(filter);
  }
}

// Applied to the ramp I = x, a first-order kernel normalised like OpenCV's gives ∂x = 1; applied to
// x²/2 a second-order one gives ∂²x = 1.
TEST(FilterBank, SobelKernelsMeasureDerivatives) {
  const auto moment = [](const Kernel& kernel, int power) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t j = 0; j < 7; ++j) {
        sum += static_cast<double>(kernel[i][j]) * std::pow(static_cast<double>(j) - 3.0, power);
      }
    }
    return sum;
  };
  for (const Filter filter : {Filter::kSobelFirst5, Filter::kSobelFirst7}) {
    EXPECT_NEAR(moment(First(KernelsOf(filter)), 1), 1.0, 1e-6) << NameOf(filter);
    EXPECT_NEAR(moment(First(KernelsOf(filter)), 0), 0.0, 1e-7) << NameOf(filter);
  }
  for (const Filter filter : {Filter::kSobelSecond5, Filter::kSobelSecond7}) {
    EXPECT_NEAR(moment(First(KernelsOf(filter)), 2), 2.0, 1e-6) << NameOf(filter);
    EXPECT_NEAR(moment(First(KernelsOf(filter)), 1), 0.0, 1e-7) << NameOf(filter);
  }
}

TEST(FilterBank, NamesReadBack) {
  for (int i = 0; i < kNumFilters; ++i) {
    EXPECT_EQ(FilterNamed(NameOf(static_cast<Filter>(i))), static_cast<Filter>(i));
  }
  EXPECT_FALSE(FilterNamed("edge_45").has_value());
}

}  // namespace
}  // namespace handcraft::features
