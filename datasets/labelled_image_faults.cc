// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/labelled_image_faults.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/fault_search.h"
#include "datasets/formats/companion_file.h"
#include "datasets/formats/set_fingerprint.h"

namespace handcraft::datasets {
namespace {

bool Has(const Image& mask, std::uint8_t value) {
  const auto& values = mask.values();
  return std::find(values.begin(), values.end(), value) != values.end();
}

PictureFindings Examine(const LabelledImageSet& set, std::size_t index) {
  PictureFindings findings;
  std::vector<Fault>& faults = findings.faults;
  const LabelledImage& item = set.items[index];
  LabelledPicture picture;
  CollectFaults(set.root, faults, [&] {
    picture = ReadLabelledPicture(set, index);
    faults = NotesOnMask(item.mask, picture.mask);
    findings.image_digest = FileDigest(set.root / item.image);
  });
  for (const std::string_view column : kCompanions) {
    const std::string path = item.Companion(column);
    if (path.empty() || picture.image.empty()) continue;
    CollectFaults(
        set.root, faults, [&] { CheckCompanion(column, set.root / path, SizeOf(picture.image)); });
  }
  return findings;
}

}  // namespace

std::vector<Fault> NotesOnMask(const std::string& path, const Image& mask) {
  std::vector<Fault> notes;
  for (const auto& [value, lack] :
       {std::pair(kMaskGood, "no good pixel (255)"), std::pair(kMaskBad, "no bad pixel (0)")}) {
    if (Has(mask, value)) continue;
    notes.push_back({.path = path,
                     .reason = std::string(lack) + ": training draws nothing from the picture",
                     .gravity = Gravity::kNote});
  }
  return notes;
}

std::vector<Fault> FindFaults(const LabelledImageSet& set,
                              int num_threads,
                              const Progress& progress) {
  return FindPictureFaults(
      set, num_threads, progress, [&](std::size_t i) { return Examine(set, i); });
}

}  // namespace handcraft::datasets
