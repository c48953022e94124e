// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/label_picture.h"

#include <array>
#include <fstream>
#include <string>

#include "lib/core/error.h"
#include "lib/core/path_kind.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

bool IsJpeg(const fs::path& path) {
  if (KindOf(path) != PathKind::kFile) return false;  // a pipe would be waited for
  std::ifstream file(path, std::ios::binary);
  std::array<char, 2> start{};
  file.read(start.data(), start.size());
  return start == std::array{'\xFF', '\xD8'};
}

}  // namespace

Image ReadLabelPicture(const fs::path& path) {
  if (IsJpeg(path)) {
    throw Error({.path = path.string(),
                 .reason = "labels in a JPEG, which changes their values",
                 .remedy = "save them as PNG, from where they were drawn"});
  }
  return perception::ReadImage(path);
}

Image ReadLabelValues(const fs::path& path) {
  Image labels = ReadLabelPicture(path);
  if (labels.channels() == 1) return labels;
  Image values(labels.width(), labels.height());
  for (int v = 0; v < labels.height(); ++v) {
    for (int u = 0; u < labels.width(); ++u) {
      values.At(u, v) = labels.At(u, v, 0);
      if (labels.At(u, v, 0) == labels.At(u, v, 1) && labels.At(u, v, 0) == labels.At(u, v, 2)) {
        continue;
      }
      throw Error({.path = path.string(),
                   .reason = "a colour at column " + std::to_string(u) + ", row " +
                             std::to_string(v) + "; gray values are due",
                   .remedy = "save the labels as a gray PNG, without a palette"});
    }
  }
  return values;
}

}  // namespace handcraft::datasets
