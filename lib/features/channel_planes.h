// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "lib/features/colour.h"
#include "lib/features/pixel_kernels.h"
#include "lib/features/pixel_region.h"

namespace handcraft::features::internal {

/// The channels of a picture as floats in 0..1 in memory that somebody else owns, each row padded
/// with copies of its first and last pixel so that filters need no border case.
class ChannelPlanes {
 public:
  enum Channel : std::size_t { kY, kCb, kCr };

  /// Floats of memory for a picture of this size.
  [[nodiscard]] static std::size_t NumFloats(int width, int height, int num_channels) noexcept;

  /// Lays the planes out in `memory` (NumFloats long); num_channels is 1 (Y) or 3. Pixels are
  /// undefined until Convert or ShrinkFrom.
  ChannelPlanes(int width, int height, int num_channels, float* memory) noexcept;

  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }
  [[nodiscard]] int num_channels() const noexcept { return num_channels_; }

  /// Reads an 8-bit picture of the same size.
  void Convert(const RawImage& image, const PixelKernels& kernels) noexcept;

  /// Reads a part of it; the pixels outside stay undefined.
  void ConvertPart(const RawImage& image,
                   const PixelKernels& kernels,
                   const RegionBox& part) noexcept;

  /// Each pixel becomes the mean of the `reduction` × `reduction` pixels of `source` it stands for
  /// (of those that exist, at the right and lower border): width = ⌈source width / reduction⌉.
  void ShrinkFrom(const ChannelPlanes& source, int reduction) noexcept;

  /// Pixel (column, v) of a channel; v is moved to the nearest row inside the picture, `column` may
  /// lie up to kPad left of it and kSlack right.
  [[nodiscard]] const float* At(Channel channel, int column, int v) const noexcept;

 private:
  [[nodiscard]] float* Row(Channel channel, int v) const noexcept;
  void PadLeft(Channel channel, int v) noexcept;
  void PadRight(Channel channel, int v) noexcept;

  int width_;
  int height_;
  int num_channels_;
  std::ptrdiff_t stride_;
  float* memory_;
};

/// Sides of a picture shrunk `reduction`-fold.
[[nodiscard]] constexpr int ShrunkSide(int side, int reduction) noexcept {
  return (side + reduction - 1) / reduction;
}

/// Memory for the energies of one row of one strip, and what it takes to make them.
struct StripBuffers {
  alignas(64) std::array<float, kNumScratchRows * kStripStride> scratch;
  alignas(64) std::array<float, kNumFilters * kStripStride> energies;
};

/// Fills buffers.energies with the energies of row v, columns x0 − kMaxRadius … x0 + width +
/// kMaxRadius − 1, one row of kStripStride a filter; columns outside the picture hold the energy of
/// the nearest column inside.
void FilterStripRow(const ChannelPlanes& planes,
                    const FilterPlan& plan,
                    const PixelKernels& kernels,
                    int x0,
                    int width,
                    int v,
                    StripBuffers& buffers) noexcept;

}  // namespace handcraft::features::internal
