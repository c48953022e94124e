// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/progress.h"
#include "lib/features/feature_spec.h"

namespace handcraft::datasets {

/// How good and bad pixels are drawn from labelled pictures (dissertation section 3.3).
struct SamplingOptions {
  std::size_t num_samples = 40000;   ///< wanted in all; 0: every labelled pixel, whatever the ratio
  double bad_per_good = 1.0;         ///< ratio, > 0; 1 as in the dissertation
  double image_share = 1.0;          ///< share of the instances whose images are used, (0, 1]
  double hard_negative_share = 0.0;  ///< share of bad pixels drawn near good ones, [0, 1]
  int hard_negative_radius_px = 40;  ///< … no farther than this from a good pixel, ≥ 1
  std::uint64_t seed = 1;
  int num_threads = 1;
  std::optional<std::uint64_t> memory = {};  ///< refuse what needs more [bytes]; none given: what
                                             ///< is available at that moment
  Progress progress = {};
  /// Told, in the order of the set, each image that is left out, and why ("no good pixel").
  std::function<void(const std::string& image, std::string_view reason)> left_out = {};

  /// Throws Error(kUsage) naming field, value and rule.
  void Validate() const;

  template <class Visitor>
  void VisitFields(Visitor&& visit) const {
    visit("num_samples", num_samples);
    visit("bad_per_good", bad_per_good);
    visit("image_share", image_share);
    visit("hard_negative_share", hard_negative_share);
    visit("hard_negative_radius_px", hard_negative_radius_px);
    visit("seed", seed);
  }
};

struct PixelSample {
  std::uint32_t image = 0;  ///< index into the set
  std::uint16_t u_px = 0;
  std::uint16_t v_px = 0;
  std::uint8_t label = 0;  ///< 1 good, 0 bad
  bool operator==(const PixelSample&) const = default;
};

/// Draws the pixels: each image gives the same number of good ones (as far as it has them; what it
/// lacks is taken from the others in turn) and bad_per_good times as many bad ones (sample_quotas.h
/// has the arithmetic); don't-care is never drawn; no pixel twice. Images without good or without
/// bad pixels are left out. Fewer than num_samples when the images have no more. Sorted by image,
/// row, column.
///
/// Which pixels of an image come first is a matter of the seed and the image's name alone: another
/// image, or another number of samples, changes how many are taken and never their order.
/// Deterministic for any number of threads. Reads the masks twice, one a thread at a time, and
/// walks each picture's file once without decoding it. Throws Error when a picture cannot be read
/// or its mask has another size, even if nothing would be drawn from it; when no image has both
/// kinds, or a class would get no pixel at all; and, before it is allocated, when the list of
/// pixels would not fit into memory.
[[nodiscard]] std::vector<PixelSample> DrawSamples(const LabelledImageSet& set,
                                                   const SamplingOptions& options);

/// The feature vectors of the samples.
struct GraspPointSamples {
  std::vector<float> features;  ///< row-major num_samples × num_features
  std::vector<std::uint8_t> labels;
  std::size_t num_features = 0;
  [[nodiscard]] std::size_t num_samples() const noexcept { return labels.size(); }
};

/// Computes the features of each sample, in their order; of `options` only num_threads, memory and
/// progress count. `samples` are sorted by image, as DrawSamples returns them. Throws Error, before
/// the features are allocated, when they would not fit into memory; when a picture cannot be read,
/// or is gray and the features look at colour; std::logic_error when a sample lies
/// outside its picture. Beside the result, one picture's energies are held a thread.
[[nodiscard]] GraspPointSamples ComputeSampleFeatures(const LabelledImageSet& set,
                                                      const std::vector<PixelSample>& samples,
                                                      const features::FeatureSpec& spec,
                                                      const SamplingOptions& options);

}  // namespace handcraft::datasets
