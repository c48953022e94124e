// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <filesystem>
#include <string>

#include "datasets/formats/labelled_image_set.h"

namespace handcraft::experiments {

/// Copies two of the sample pictures, with their masks, into an empty folder.
inline void CopyTwoPictures(const std::filesystem::path& folder) {
  datasets::LabelledImageSet set = datasets::ReadLabelledImageSet(
      std::string(HANDCRAFT_SOURCE_DIR) + "/datasets/samples/cornell_mini");
  set.items.resize(2);
  std::filesystem::create_directories(folder / "images");
  std::filesystem::create_directories(folder / "masks");
  for (const datasets::LabelledImage& item : set.items) {
    std::filesystem::copy(set.root / item.image, folder / item.image);
    std::filesystem::copy(set.root / item.mask, folder / item.mask);
  }
  set.root = folder;
  datasets::WriteManifest(set);
}

}  // namespace handcraft::experiments
