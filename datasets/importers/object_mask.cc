// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/object_mask.h"

#include <algorithm>
#include <array>
#include <vector>

#include "datasets/formats/mask_picture.h"
#include "datasets/formats/view_set.h"
#include "datasets/importers/label_picture.h"
#include "datasets/importers/source_tree.h"

namespace handcraft::datasets {

Image ReadObjectMask(const std::filesystem::path& path, int width, int height) {
  Image mask = ReadLabelValues(path);
  RequireSameSize(path, "the mask", {mask.width(), mask.height()}, {width, height});
  for (int v = 0; v < height; ++v) {
    std::uint8_t* const row = mask.Row(v);
    std::transform(
        row, row + width, row, [](std::uint8_t x) { return x == 0 ? kNoObject : kObject; });
  }
  return mask;
}

Image MaskBeforeDarkness(const Image& image, std::uint8_t threshold) {
  Image mask(image.width(), image.height(), 1, kObject);
  std::vector<std::array<int, 2>> to_visit;
  const auto reach = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= image.width() || v >= image.height()) return;
    if (mask.At(u, v) == kNoObject) return;
    for (int channel = 0; channel < image.channels(); ++channel) {
      if (image.At(u, v, channel) > threshold) return;
    }
    mask.At(u, v) = kNoObject;
    to_visit.push_back({u, v});
  };
  for (int u = 0; u < image.width(); ++u) reach(u, 0), reach(u, image.height() - 1);
  for (int v = 0; v < image.height(); ++v) reach(0, v), reach(image.width() - 1, v);
  while (!to_visit.empty()) {
    const auto [u, v] = to_visit.back();
    to_visit.pop_back();
    reach(u - 1, v), reach(u + 1, v), reach(u, v - 1), reach(u, v + 1);
  }
  return mask;
}

}  // namespace handcraft::datasets
