// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/evaluation_pixels.h"

#include <algorithm>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/rng.h"

namespace handcraft::experiments {

std::vector<EvaluationPixel> DrawEvaluationPixels(const Image& mask,
                                                  std::size_t count,
                                                  std::uint64_t seed,
                                                  std::string_view image_name) {
  std::vector<std::size_t> good;
  std::vector<std::size_t> bad;
  const std::vector<std::uint8_t>& values = mask.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == datasets::kMaskGood) good.push_back(i);
    if (values[i] == datasets::kMaskBad) bad.push_back(i);
  }
  const bool has_both = !good.empty() && !bad.empty();
  const std::size_t available =
      has_both ? std::min(good.size(), bad.size()) : std::max(good.size(), bad.size());
  const std::size_t wanted = std::min(count / 2, available);
  Rng rng = Rng::Stream(seed, "evaluation/" + std::string(image_name));
  std::vector<EvaluationPixel> pixels;
  if (!good.empty()) {
    for (const std::size_t k : rng.SampleSorted(good.size(), wanted))
      pixels.push_back({good[k], 1});
  }
  if (!bad.empty()) {
    for (const std::size_t k : rng.SampleSorted(bad.size(), wanted)) pixels.push_back({bad[k], 0});
  }
  return pixels;
}

}  // namespace handcraft::experiments
