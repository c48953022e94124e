// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace handcraft::features {

/// The filters a pixel is described by, in the order of the dissertation (section 3.1.3): nine Laws
/// masks, six oriented edge masks, five Sobel and Laplacian channels, all on the intensity Y; then
/// the two chroma averages of Saxena et al. (section 3.1.1). The numbers are part of the model
/// file.
enum class Filter : std::uint8_t {
  kLawsLL = 0,
  kLawsLE,
  kLawsLS,
  kLawsEL,
  kLawsEE,
  kLawsES,
  kLawsSL,
  kLawsSE,
  kLawsSS,
  kEdge0,
  kEdge30,
  kEdge60,
  kEdge90,
  kEdge120,
  kEdge150,
  kSobelFirst5,
  kSobelSecond5,
  kSobelFirst7,
  kSobelSecond7,
  kLaplacian,
  kChromaBlueLL,  ///< LL on Cb
  kChromaRedLL,   ///< LL on Cr
};

inline constexpr int kNumIntensityFilters = 20;
inline constexpr int kNumFilters = 22;

/// Side of the square that holds every kernel [px].
inline constexpr int kKernelSize = 7;
using Kernel = std::array<std::array<float, kKernelSize>, kKernelSize>;  ///< [row][column], centred

/// A filter as numbers. Its energy at a pixel is the sum over components of the squared true
/// convolution of the channel with the component:
///   E = Σ_c ( Σ_{i,j} component_c[i][j] · I(x − (j − 3), y − (i − 3)) )²
/// with the picture's border replicated. Directional Sobel channels have two components (∂x, ∂y),
/// all others one; the unused component is zero.
struct FilterKernels {
  std::array<Kernel, 2> components{};
  int num_components = 1;
};

/// The kernels of one filter. Pure; allocates nothing.
[[nodiscard]] FilterKernels KernelsOf(Filter filter) noexcept;

/// "laws_LL", …, "edge_0", …, "sobel1_5", "sobel2_5", "sobel1_7", "sobel2_7", "laplacian", "cb_LL",
/// "cr_LL".
[[nodiscard]] std::string_view NameOf(Filter filter) noexcept;
[[nodiscard]] std::optional<Filter> FilterNamed(std::string_view name) noexcept;

}  // namespace handcraft::features
