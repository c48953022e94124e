// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "datasets/formats/labelled_image_set.h"
#include "experiments/runner/study.h"
#include "lib/core/rng.h"
#include "lib/perception/image_io.h"

namespace handcraft::testing {

/// Eight pictures of 24 × 16 in two classes and eight instances; the left half is rough and good,
/// the right one nearly smooth and bad.
inline void WriteRoughSet(const std::filesystem::path& root, std::uint64_t seed = 1) {
  std::filesystem::create_directories(root);
  datasets::LabelledImageSet set{.root = root, .items = {}};
  for (int i = 0; i < 8; ++i) {
    Rng rng = Rng::Stream(seed, "rough", static_cast<std::uint64_t>(i));
    Image image(24, 16);
    Image mask(24, 16);
    for (int v = 0; v < 16; ++v) {
      for (int u = 0; u < 24; ++u) {
        const std::uint64_t roughness = u < 12 ? 90 : 40;
        image.At(u, v) = static_cast<std::uint8_t>(80 + rng.UniformInt(roughness));
        mask.At(u, v) = u < 12 ? datasets::kMaskGood : datasets::kMaskBad;
      }
    }
    const std::string name = "p" + std::to_string(i);
    perception::WritePng(root / (name + ".png"), image);
    perception::WritePng(root / (name + "_mask.png"), mask);
    set.items.push_back({name + ".png",
                         name + "_mask.png",
                         i % 2 == 0 ? "even" : "odd",
                         name,
                         i < 4 ? "train" : "test",
                         "CC0-1.0"});
  }
  WriteManifest(set);
}

/// Two methods, two ridges, two repetitions: eight cells, some milliseconds each.
inline experiments::Study SmallStudy(const std::filesystem::path& data) {
  return {.name = "small",
          .title = "Rough <or> smooth",
          .question = "Which filter?",
          .train = {.folder = data.string()},
          .repetitions = 2,
          .pixels_per_image = 40,
          .bootstrap_resamples = 40,
          .settings = {{"samples", "200"}, {"training_share", "0.5"}},
          .methods = {{"laplacian", {{"features", "filters=laplacian,window=1,energy=log"}}},
                      {"edge", {{"features", "filters=edge_0,window=1,energy=log"}}}},
          .factors = {{"ridge", {"0.5", "2"}}},
          .baseline = "laplacian"};
}

}  // namespace handcraft::testing
