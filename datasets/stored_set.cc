// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/stored_set.h"

#include <algorithm>
#include <string>
#include <utility>

#include "datasets/formats/csv_column.h"
#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/listing_rules.h"
#include "datasets/formats/required_list.h"
#include "datasets/labelled_image_faults.h"
#include "datasets/view_set_faults.h"
#include "lib/core/error.h"
#include "lib/core/path_kind.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

std::size_t AddRowFaults(RowFindings findings, std::vector<Fault>& faults) {
  faults.insert(faults.end(), findings.faults.begin(), findings.faults.end());
  return findings.num_rows;
}

}  // namespace

const fs::path& StoredSet::root() const {
  return std::visit([](const auto& set) -> const fs::path& { return set.root; }, pictures);
}

fs::path StoredSet::list() const {
  return root() / (std::holds_alternative<ViewSet>(pictures) ? kViewsFileName : kManifestFileName);
}

StoredSet OpenSet(const fs::path& root) {
  const bool has_manifest = KindOf(root / kManifestFileName) != PathKind::kNothing;
  const bool has_views = KindOf(root / kViewsFileName) != PathKind::kNothing;
  if (has_manifest && has_views) {
    throw Error({.path = root.string(),
                 .reason = "both manifest.csv and views.csv in this folder",
                 .remedy = "keep each set in a folder of its own"});
  }
  if (has_views) {
    return {.pictures = ReadViewSet(root),
            .has_demonstrations = KindOf(root / kDemonstrationsFileName) != PathKind::kNothing,
            .has_holds = KindOf(root / kHoldsFileName) != PathKind::kNothing};
  }
  if (KindOf(root) == PathKind::kFolder && !has_manifest && !Exists(root / kMadeUpFileName)) {
    throw Error({.path = root.string(),
                 .reason = "neither manifest.csv nor views.csv in this folder: not a data set",
                 .remedy = "see docs/datasets.md, or make one with handcraft data import or "
                           "handcraft data synth"});
  }
  return {.pictures = ReadLabelledImageSet(root)};
}

CheckedSet CheckSet(const StoredSet& set, int num_threads, const Progress& progress) {
  CheckedSet checked;
  std::visit(
      [&](const auto& pictures) {
        checked.num_images = pictures.items.size();
        checked.faults = FindFaults(pictures, num_threads, progress);
      },
      set.pictures);
  if (set.has_demonstrations) {
    checked.num_demonstrations = AddRowFaults(CheckDemonstrations(set.root()), checked.faults);
  }
  if (set.has_holds) checked.num_holds = AddRowFaults(CheckHolds(set.root()), checked.faults);
  const auto first_note =
      std::stable_partition(checked.faults.begin(), checked.faults.end(), [](const Fault& fault) {
        return fault.gravity == Gravity::kFault;
      });
  checked.notes.assign(first_note, checked.faults.end());
  checked.faults.erase(first_note, checked.faults.end());
  return checked;
}

void RewriteSplits(const StoredSet& set) {
  std::vector<std::string> splits;
  std::visit(
      [&](const auto& pictures) {
        for (const auto& item : pictures.items) splits.push_back(item.split);
      },
      set.pictures);
  RewriteCsvColumn(set.list(), "split", splits);
}

}  // namespace handcraft::datasets
