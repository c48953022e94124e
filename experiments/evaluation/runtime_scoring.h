// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "lib/core/image.h"
#include "lib/runtime/handcraft_runtime.h"

namespace handcraft::experiments {

/// A picture scored by the runtime, as a robot would do it.
struct RuntimeScores {
  FloatImage probabilities;
  double score_ms = 0.0;  ///< of hc_score_image or hc_score_mask alone, by the steady clock
};

/// Scores the pixels that are not 0 in a mask of the picture's size, the others get 0; all pixels
/// without a mask. Throws Error(kBadInput) with the picture's path and the runtime's sentence when
/// the model cannot score it (no grasp-point model, colour needed, too large). Thread-safe;
/// allocates a workspace.
[[nodiscard]] RuntimeScores ScoreWithRuntime(const hc_model* model,
                                             const Image& image,
                                             const std::string& path,
                                             const Image* mask = nullptr);

/// hc_top_k: up to max_count pixels whose probability exceeds min_probability, best first.
[[nodiscard]] std::vector<hc_point> FindBestPixels(const FloatImage& probabilities,
                                                   int max_count,
                                                   double min_probability,
                                                   int suppression_radius_px);

}  // namespace handcraft::experiments
