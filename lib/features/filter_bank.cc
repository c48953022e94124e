// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/filter_bank.h"

#include <cstddef>
#include <span>

namespace handcraft::features {
namespace {

constexpr std::array<std::string_view, kNumFilters> kNames = {
    "laws_LL",  "laws_LE",  "laws_LS",  "laws_EL",   "laws_EE", "laws_ES",  "laws_SL",  "laws_SE",
    "laws_SS",  "edge_0",   "edge_30",  "edge_60",   "edge_90", "edge_120", "edge_150", "sobel1_5",
    "sobel2_5", "sobel1_7", "sobel2_7", "laplacian", "cb_LL",   "cr_LL"};

// Laws' three-tap level, edge and spot vectors.
constexpr std::array<std::array<float, 3>, 3> kLaws = {{{1, 2, 1}, {-1, 0, 1}, {-1, 2, -1}}};

// Nevatia and Babu 1980, the 30 degree mask; all six follow from it and the 0 degree mask.
using Mask5 = std::array<std::array<float, 5>, 5>;
constexpr Mask5 kEdge0Mask = {{{-100, -100, 0, 100, 100},
                               {-100, -100, 0, 100, 100},
                               {-100, -100, 0, 100, 100},
                               {-100, -100, 0, 100, 100},
                               {-100, -100, 0, 100, 100}}};
constexpr Mask5 kEdge30Mask = {{{-100, 32, 100, 100, 100},
                                {-100, -78, 92, 100, 100},
                                {-100, -100, 0, 100, 100},
                                {-100, -100, -92, 78, 100},
                                {-100, -100, -100, -32, 100}}};
constexpr float kEdgeDivisor = 2000.0F;

// One-dimensional Sobel kernels of OpenCV's getDerivKernels(normalize = true): order 0 smooths.
constexpr std::array<std::array<float, 5>, 3> kSobel5 = {
    {{1, 4, 6, 4, 1}, {-1, -2, 0, 2, 1}, {1, 0, -2, 0, 1}}};
constexpr std::array<std::array<float, 7>, 3> kSobel7 = {
    {{1, 6, 15, 20, 15, 6, 1}, {-1, -4, -5, 0, 5, 4, 1}, {1, 2, -1, -4, -1, 2, 1}}};

// column ⊗ row, centred in the kernel's square, times `factor`.
Kernel OuterProduct(std::span<const float> column, std::span<const float> row, float factor) {
  Kernel kernel{};
  const std::size_t top = (kKernelSize - column.size()) / 2;
  const std::size_t left = (kKernelSize - row.size()) / 2;
  for (std::size_t i = 0; i < column.size(); ++i) {
    for (std::size_t j = 0; j < row.size(); ++j) {
      kernel[top + i][left + j] = factor * column[i] * row[j];
    }
  }
  return kernel;
}

Mask5 NegativeTranspose(const Mask5& mask) noexcept {
  Mask5 result{};
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < 5; ++j) result[i][j] = 0.0F - mask[j][i];
  }
  return result;
}

Mask5 NegativeFlipUpDown(const Mask5& mask) noexcept {
  Mask5 result{};
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < 5; ++j) result[i][j] = 0.0F - mask[4 - i][j];
  }
  return result;
}

// 120° = −flipud(60°), 60° = −(30°)ᵀ, 90° = −(0°)ᵀ, 150° = (120°)ᵀ.
Mask5 EdgeMask(Filter filter) noexcept {
  const Mask5 edge60 = NegativeTranspose(kEdge30Mask);
  switch (filter) {
    case Filter::kEdge0:
      return kEdge0Mask;
    case Filter::kEdge30:
      return kEdge30Mask;
    case Filter::kEdge60:
      return edge60;
    case Filter::kEdge90:
      return NegativeTranspose(kEdge0Mask);
    case Filter::kEdge120:
      return NegativeFlipUpDown(edge60);
    default: {
      Mask5 edge150 = NegativeTranspose(NegativeFlipUpDown(edge60));
      for (auto& row : edge150) {
        for (float& weight : row) weight = 0.0F - weight;
      }
      return edge150;
    }
  }
}

FilterKernels EdgeKernels(Filter filter) noexcept {
  FilterKernels kernels;
  const Mask5 mask = EdgeMask(filter);
  for (std::size_t i = 0; i < 5; ++i) {
    for (std::size_t j = 0; j < 5; ++j)
      kernels.components[0][i + 1][j + 1] = mask[i][j] / kEdgeDivisor;
  }
  return kernels;
}

// ∂x of the given order (derivative along the row, smoothing along the column) and ∂y; the factor
// 2^-(2·size − order − 2) makes each one-dimensional kernel's scale that of getDerivKernels.
FilterKernels SobelKernels(std::span<const float> smooth,
                           std::span<const float> derivative,
                           int order) {
  const int exponent = 2 * static_cast<int>(smooth.size()) - order - 2;
  const float factor = 1.0F / static_cast<float>(1 << exponent);
  return {{OuterProduct(smooth, derivative, factor), OuterProduct(derivative, smooth, factor)}, 2};
}

FilterKernels LawsKernels(int index) noexcept {
  const auto column = static_cast<std::size_t>(index / 3);
  const auto row = static_cast<std::size_t>(index % 3);
  return {{OuterProduct(kLaws[column], kLaws[row], 1.0F), Kernel{}}, 1};
}

FilterKernels LaplacianKernels() noexcept {
  FilterKernels kernels;
  Kernel& kernel = kernels.components[0];
  kernel[3][3] = -4.0F;
  kernel[2][3] = kernel[4][3] = kernel[3][2] = kernel[3][4] = 1.0F;
  return kernels;
}

}  // namespace

FilterKernels KernelsOf(Filter filter) noexcept {
  switch (filter) {
    case Filter::kSobelFirst5:
      return SobelKernels(kSobel5[0], kSobel5[1], 1);
    case Filter::kSobelSecond5:
      return SobelKernels(kSobel5[0], kSobel5[2], 2);
    case Filter::kSobelFirst7:
      return SobelKernels(kSobel7[0], kSobel7[1], 1);
    case Filter::kSobelSecond7:
      return SobelKernels(kSobel7[0], kSobel7[2], 2);
    case Filter::kLaplacian:
      return LaplacianKernels();
    case Filter::kChromaBlueLL:
    case Filter::kChromaRedLL:
      return LawsKernels(0);
    case Filter::kEdge0:
    case Filter::kEdge30:
    case Filter::kEdge60:
    case Filter::kEdge90:
    case Filter::kEdge120:
    case Filter::kEdge150:
      return EdgeKernels(filter);
    default:
      return LawsKernels(static_cast<int>(filter));
  }
}

std::string_view NameOf(Filter filter) noexcept { return kNames[static_cast<std::size_t>(filter)]; }

std::optional<Filter> FilterNamed(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (kNames[i] == name) return static_cast<Filter>(i);
  }
  return std::nullopt;
}

}  // namespace handcraft::features
