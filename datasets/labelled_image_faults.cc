// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/labelled_image_faults.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "datasets/fault_search.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/formats/organised_cloud.h"
#include "datasets/formats/set_fingerprint.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

bool Has(const Image& mask, std::uint8_t value) {
  const auto& values = mask.values();
  return std::find(values.begin(), values.end(), value) != values.end();
}

// Throws unless the companion in this column is of the picture's size.
template <class Companion>
void CheckSize(std::string_view column,
               const fs::path& path,
               const Companion& companion,
               const Image& image) {
  RequireSameSize(path, "the " + std::string(column), SizeOf(companion), SizeOf(image));
}

void CheckCompanion(std::string_view column, const fs::path& path, const Image& image) {
  if (column == kObjectMask) {
    CheckSize(column, path, ReadObjectMask(path), image);
  } else if (column == kDepth) {
    CheckSize(column, path, perception::ReadImage16(path), image);
  } else if (column == kRightImage) {
    CheckSize(column, path, perception::ReadImage(path), image);
  } else if (column == kCloud) {
    CheckSize(column, path, ReadPcd(path), image);
  } else if (ReadFile(path).empty()) {
    throw Error({.path = path.string(), .reason = "the file is empty"});
  }
}

PictureFindings Examine(const LabelledImageSet& set, std::size_t index) {
  PictureFindings findings;
  std::vector<Fault>& faults = findings.faults;
  const LabelledImage& item = set.items[index];
  LabelledPicture picture;
  CollectFaults(set.root, faults, [&] {
    picture = ReadLabelledPicture(set, index);
    if (!Has(picture.mask, kMaskGood))
      faults.push_back({item.mask, "no good pixel (255): the picture is left out"});
    if (!Has(picture.mask, kMaskBad))
      faults.push_back({item.mask, "no bad pixel (0): the picture is left out"});
    findings.image_digest = FileDigest(set.root / item.image);
  });
  for (const std::string_view column : kCompanions) {
    const std::string path = item.Companion(column);
    if (path.empty() || picture.image.empty()) continue;
    CollectFaults(
        set.root, faults, [&] { CheckCompanion(column, set.root / path, picture.image); });
  }
  return findings;
}

}  // namespace

std::vector<Fault> FindFaults(const LabelledImageSet& set,
                              int num_threads,
                              const Progress& progress) {
  return FindPictureFaults(
      set, num_threads, progress, [&](std::size_t i) { return Examine(set, i); });
}

}  // namespace handcraft::datasets
