// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/features/colour.h"
#include "lib/features/feature_spec.h"
#include "lib/features/instruction_set.h"
#include "lib/features/pixel_region.h"

namespace handcraft::features {

namespace internal {
struct RegionOutput;
}

/// Scores every pixel of a picture with a linear model on its features, without ever forming the
/// feature vectors:
///   z(u, v) = intercept + Σ_f Σ_{dv,du} w[f, dv, du] · e_f(u + du, v + dv),  p = 1 / (1 + e^{−z}).
/// That is a sum over filters of one small correlation each. The picture is cut into vertical
/// strips and each row of a strip is filtered and correlated while it sits in the first-level
/// cache.
///
/// Immutable after construction; Score may be called from many threads, each with a workspace of
/// its own. Deterministic: same picture, same weights, same bits (see InstructionSet). Source:
/// dissertation section 3.1.2, Eq. (3.2); rearranged as docs/methods/grasp_point_features.md.
class PixelScorer {
 public:
  /// `weights`: spec.NumFeatures() numbers in the order of FeatureSpec. Throws std::logic_error on
  /// a wrong count or an invalid spec. Allocates.
  PixelScorer(FeatureSpec spec,
              std::span<const float> weights,
              double intercept,
              InstructionSet instruction_set = SupportedInstructionSets().back());

  [[nodiscard]] const FeatureSpec& spec() const noexcept { return spec_; }
  [[nodiscard]] InstructionSet instruction_set() const noexcept { return instruction_set_; }

  /// Bytes that scoring needs for a picture of at most this size, for any pixel format.
  [[nodiscard]] std::size_t WorkspaceBytes(int max_width, int max_height) const noexcept;

  /// Writes the probability of every pixel: row v at probabilities + v · stride (in floats).
  /// `workspace` is aligned to 64 bytes and at least WorkspaceBytes(width, height) long.
  /// Preconditions (non-empty picture, colour if needed, sizes) are the caller's; nothing is
  /// checked, allocated or thrown.
  void Score(const RawImage& image,
             std::span<std::byte> workspace,
             float* probabilities,
             std::ptrdiff_t stride) const noexcept;

  /// As Score, but leaves the decision values z instead of the probabilities.
  void ScoreDecisionValues(const RawImage& image,
                           std::span<std::byte> workspace,
                           float* decision_values,
                           std::ptrdiff_t stride) const noexcept;

  /// Whether the wanted pixels of a picture are scored sooner alone or with all others: by the
  /// filters, columns and runs that either way computes (docs/methods/search_space_reduction.md).
  [[nodiscard]] ScoringWay CheaperWay(int width, int height, const PixelMask& mask) const noexcept;

  /// Writes the probability of every pixel that is not 0 in the mask, and 0 for the others; both
  /// ways write the same bits, those of Score. Preconditions as for Score; the mask is of the
  /// picture's size.
  void ScoreMask(const RawImage& image,
                 const PixelMask& mask,
                 ScoringWay way,
                 std::span<std::byte> workspace,
                 float* probabilities,
                 std::ptrdiff_t stride) const noexcept;

  /// Writes the probability of pixels[i] to probabilities[i], with the bits of Score. The pixels
  /// lie in the picture and are in the order of their rows. Always in the sparse way.
  void ScorePixels(const RawImage& image,
                   std::span<const PixelPosition> pixels,
                   std::span<std::byte> workspace,
                   float* probabilities) const noexcept;

 private:
  void Run(const RawImage& image,
           std::span<std::byte> workspace,
           const internal::RegionOutput& output,
           const PixelMask* mask,
           bool as_probability) const noexcept;

  FeatureSpec spec_;
  InstructionSet instruction_set_;
  std::vector<float> packed_weights_;
  double intercept_;
};

}  // namespace handcraft::features
