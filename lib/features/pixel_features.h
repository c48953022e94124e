// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <vector>

#include "lib/core/image.h"
#include "lib/features/colour.h"
#include "lib/features/feature_spec.h"
#include "lib/features/instruction_set.h"

namespace handcraft::features {

/// The energies of every filter at every pixel of one picture (and of its shrunk copies: pixel (u,
/// v) of the picture is pixel (⌊u/s⌋, ⌊v/s⌋) of the one shrunk s-fold by averaging s × s pixels),
/// from which the feature vector of any pixel is read: the trainer's side of the features. Made by
/// the same vector code as the scores (pixel_scorer.h), hence with the same bits.
class PixelFeatures {
 public:
  /// Filters the picture. Cost: about 10 bytes written and 6 multiply-adds a filter and pixel.
  /// Throws std::logic_error when the spec is invalid, the picture empty, or colour is needed and
  /// the picture is gray. Allocates num_filters · width · height floats (and the small scales).
  PixelFeatures(const RawImage& image,
                FeatureSpec spec,
                InstructionSet instruction_set = SupportedInstructionSets().back());

  [[nodiscard]] const FeatureSpec& spec() const noexcept { return spec_; }
  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }

  /// Energies of filter f (index into spec().filters), num_rows = height, stride = width.
  [[nodiscard]] ImageView<float> EnergyPlane(int filter_index) const noexcept;

  /// Writes the feature vector of pixel (u, v) [px] into `features`, spec().NumFeatures() long.
  void Gather(int u, int v, std::span<float> features) const;

 private:
  struct Level {
    int reduction = 1;
    int width = 0;
    int height = 0;
    std::vector<float> energies;  ///< [filter][row][column]
  };

  FeatureSpec spec_;
  int width_;
  int height_;
  std::vector<Level> levels_;  ///< full size first, then spec_.scales in order
};

}  // namespace handcraft::features
