// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lib/features/colour.h"
#include "lib/features/feature_spec.h"
#include "lib/features/instruction_set.h"

namespace handcraft::features::internal {

/// Inner loops of the features, compiled once for each instruction set. Every loop works on whole
/// vectors and may read and write up to kSlack floats past the last column it was asked for; the
/// buffers of this folder are laid out for that. Nothing here allocates, checks or throws.

/// Columns of padding left of column 0 and right of the last one of a channel plane [px].
inline constexpr int kPad = 16;
/// Floats that a loop may touch past the end: one vector of the widest set and the filters' reach.
inline constexpr int kSlack = 32;
/// Columns of energies computed at a time: with 20 filters, energies and scratch stay near 24 KiB.
inline constexpr int kStripWidth = 128;
/// A strip of energies starts two columns left of its first pixel: the window's radius.
inline constexpr int kMaxRadius = 2;
/// Floats of one row of strip buffers, a multiple of 16.
inline constexpr int kStripStride = kStripWidth + 2 * kMaxRadius + 12 + kSlack;

/// Intermediate rows of the separable filters, one kStripStride row each (see FilterRow).
inline constexpr int kNumScratchRows = 20;

/// Which filters a row of energies is wanted for; made once from a FeatureSpec.
struct FilterPlan {
  std::array<int, kNumFilters> slot{};  ///< row of the output for a filter, −1: not wanted
  int num_filters = 0;
  Energy energy = Energy::kSquare;
  bool laws = false;  ///< any filter of the group is wanted
  bool edges = false;
  bool sobel5 = false;
  bool sobel7 = false;
  bool chroma = false;

  explicit FilterPlan(const FeatureSpec& spec) noexcept;
};

/// One row of energies. Row pointers point at the column of the first energy.
struct FilterRowJob {
  std::array<const float*, kKernelSize>
      y_rows{};                           ///< rows v − 3 … v + 3 of Y, replicated at the border
  std::array<const float*, 3> cb_rows{};  ///< rows v − 1 … v + 1 of Cb, if wanted
  std::array<const float*, 3> cr_rows{};
  int count = 0;              ///< energies wanted, ≤ kStripWidth + 2 · kMaxRadius
  float* scratch = nullptr;   ///< kNumScratchRows · kStripStride floats
  float* energies = nullptr;  ///< plan.num_filters rows of kStripStride floats
};

/// Adds one row of energies to the window's rows of decision values:
///   z_j[x] += Σ_f Σ_i w[f][i][j] · e_f[x + i − r],  j = 0 … window − 1.
struct CorrelateRowJob {
  const float* energies = nullptr;  ///< plan.num_filters rows, energy of pixel x − kMaxRadius first
  const float* weights = nullptr;  ///< [filter][column i][row j]
  int num_filters = 0;
  int window = 5;
  int count = 0;                 ///< pixels
  std::array<float*, 5> sums{};  ///< z_j
};

struct PixelKernels {
  /// 8-bit pixels to planes of floats in 0..1 (cb and cr may be null). Exactly `count` pixels are
  /// read; the planes are written up to a whole vector past them.
  void (*convert_row)(
      const std::uint8_t* pixels, PixelFormat format, int count, float* y, float* cb, float* cr);
  void (*filter_row)(const FilterPlan& plan, const FilterRowJob& job);
  void (*correlate_row)(const CorrelateRowJob& job);
  /// z → 1 / (1 + e^{−z}) in place, within 2 ulp; exactly 0 and 1 beyond |z| = 88.
  void (*sigmoid_row)(float* values, int count);
};

/// The kernels of an instruction set; one that this program has no code for gives the baseline.
[[nodiscard]] const PixelKernels& KernelsFor(InstructionSet set) noexcept;

}  // namespace handcraft::features::internal
