// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/view_set_faults.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "datasets/fault_search.h"
#include "datasets/formats/companion_file.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/set_fingerprint.h"

namespace handcraft::datasets {
namespace {

void FindFaultsOf(const LoadedView& view, const ObjectView& item, std::vector<Fault>& faults) {
  std::size_t num_object = 0;
  std::size_t num_measured = 0;
  for (std::size_t i = 0; i < view.object_mask.values().size(); ++i) {
    if (view.object_mask.values()[i] != kObject) continue;
    ++num_object;
    if (view.cloud && IsMeasured(view.cloud->points[i])) ++num_measured;
  }
  if (num_object == 0) {
    faults.push_back({item.object_mask, "no pixel of an object (255)"});
  } else if (view.cloud && num_measured == 0) {
    faults.push_back({item.cloud, "no point of the object was measured"});
  }
}

PictureFindings Examine(const ViewSet& set, std::size_t index) {
  const ObjectView& item = set.items[index];
  PictureFindings findings;
  std::optional<PixelSize> picture_size;
  CollectFaults(set.root, findings.faults, [&] {
    const LoadedView view = ReadView(set, index);
    picture_size = SizeOf(view.image);
    FindFaultsOf(view, item, findings.faults);
    findings.image_digest = FileDigest(set.root / item.image);
  });
  if (!picture_size) return findings;
  using Companion = std::pair<std::string_view, const std::string&>;
  for (const Companion& companion :
       {Companion(kDepth, item.depth), Companion(kScene, item.scene)}) {
    if (companion.second.empty()) continue;
    CollectFaults(set.root, findings.faults, [&] {
      CheckCompanion(companion.first, set.root / companion.second, *picture_size);
    });
  }
  return findings;
}

}  // namespace

std::vector<Fault> FindFaults(const ViewSet& set, int num_threads, const Progress& progress) {
  return FindPictureFaults(
      set, num_threads, progress, [&](std::size_t i) { return Examine(set, i); });
}

}  // namespace handcraft::datasets
