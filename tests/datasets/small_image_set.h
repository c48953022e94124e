// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/rng.h"
#include "lib/perception/image_io.h"

namespace handcraft::testing {

/// A picture of noise.
inline Image NoiseImage(int width, int height, int channels, std::uint64_t seed) {
  Image image(width, height, channels);
  Rng rng = Rng::Stream(seed, "NoiseImage");
  for (int v = 0; v < height; ++v) {
    for (int i = 0; i < width * channels; ++i) {
      image.Row(v)[i] = static_cast<std::uint8_t>(rng.UniformInt(256));
    }
  }
  return image;
}

/// A mask in which `num_good` and `num_bad` pixels stand in row-major order, the rest don't care.
inline Image CountedMask(int width, int height, int num_good, int num_bad) {
  Image mask(width, height, 1, datasets::kMaskDontCare);
  for (int i = 0; i < num_good; ++i) mask.Row(0)[i] = datasets::kMaskGood;
  for (int i = 0; i < num_bad; ++i) mask.Row(0)[num_good + i] = datasets::kMaskBad;
  return mask;
}

/// Adds a picture with its mask to a set below `set.root`, which must exist: files <name>.png and
/// <name>_mask.png, instance <name>.
inline void AddPicture(datasets::LabelledImageSet& set,
                       const std::string& name,
                       const Image& image,
                       const Image& mask,
                       const std::string& split = "train") {
  perception::WritePng(set.root / (name + ".png"), image);
  perception::WritePng(set.root / (name + "_mask.png"), mask);
  set.items.push_back({.image = name + ".png",
                       .mask = name + "_mask.png",
                       .object_class = "object",
                       .instance = name,
                       .split = split,
                       .licence = "CC0-1.0"});
}

/// Good and bad pixels mixed at random, a third of each kind.
inline Image MixedMask(int width, int height, std::uint64_t seed) {
  Image mask(width, height);
  Rng rng = Rng::Stream(seed, "MixedMask");
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      mask.At(u, v) = std::array{
          datasets::kMaskGood, datasets::kMaskBad, datasets::kMaskDontCare}[rng.UniformInt(3)];
    }
  }
  return mask;
}

/// Four pictures of 40 × 30; "b" has few good pixels, "d" only bad ones.
inline datasets::LabelledImageSet MakeSet(const std::filesystem::path& root) {
  datasets::LabelledImageSet set{.root = root, .items = {}};
  AddPicture(set, "a", NoiseImage(40, 30, 3, 1), MixedMask(40, 30, 1));
  AddPicture(set, "b", NoiseImage(40, 30, 1, 2), CountedMask(40, 30, 20, 500));
  AddPicture(set, "c", NoiseImage(40, 30, 3, 3), MixedMask(40, 30, 3));
  AddPicture(set, "d", NoiseImage(40, 30, 3, 4), CountedMask(40, 30, 0, 500));
  return set;
}

}  // namespace handcraft::testing
