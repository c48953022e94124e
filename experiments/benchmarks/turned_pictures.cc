// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/benchmarks/turned_pictures.h"

#include <algorithm>
#include <string>
#include <utility>

#include "lib/core/check.h"
#include "lib/perception/image_io.h"

namespace handcraft::experiments {

Image Turn(const Image& image, int turn) {
  HC_CHECK(turn >= 0 && turn < kNumTurns, turn);
  const bool swaps = (turn & 4) != 0;
  Image out(swaps ? image.height() : image.width(),
            swaps ? image.width() : image.height(),
            image.channels());
  for (int v = 0; v < out.height(); ++v) {
    for (int u = 0; u < out.width(); ++u) {
      const int from_u = swaps ? v : u;
      const int from_v = swaps ? u : v;
      for (int channel = 0; channel < image.channels(); ++channel) {
        out.At(u, v, channel) = image.At((turn & 1) != 0 ? image.width() - 1 - from_u : from_u,
                                         (turn & 2) != 0 ? image.height() - 1 - from_v : from_v,
                                         channel);
      }
    }
  }
  return out;
}

datasets::LabelledImageSet WriteTurnedPictures(const datasets::LabelledImageSet& set,
                                               std::size_t num_good,
                                               const std::filesystem::path& out) {
  datasets::LabelledImageSet turned{.root = out, .items = {}};
  std::size_t good = 0;
  for (int turn = 0; turn < kNumTurns && good < num_good; ++turn) {
    for (std::size_t i = 0; i < set.items.size(); ++i) {
      const datasets::LabelledPicture picture = datasets::ReadLabelledPicture(set, i);
      datasets::LabelledImage item = set.items[i];
      const std::string name = std::to_string(turn) + "_" + std::to_string(i);
      item.image = name + "_image.png";
      item.mask = name + "_mask.png";
      perception::WritePng(out / item.image, Turn(picture.image, turn));
      perception::WritePng(out / item.mask, Turn(picture.mask, turn));
      turned.items.push_back(std::move(item));
      const auto& mask = picture.mask.values();
      good += static_cast<std::size_t>(std::count(mask.begin(), mask.end(), datasets::kMaskGood));
    }
  }
  datasets::WriteManifest(turned);
  return turned;
}

}  // namespace handcraft::experiments
