// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/stored_set.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "datasets/formats/csv_column.h"
#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/listing_rules.h"
#include "datasets/formats/required_list.h"
#include "datasets/importers/source_tree.h"
#include "datasets/labelled_image_faults.h"
#include "datasets/view_set_faults.h"
#include "lib/core/error.h"
#include "lib/core/path_kind.h"
#include "lib/structured_text/toml_file.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

std::size_t AddRowFaults(RowFindings findings, std::vector<Fault>& faults) {
  faults.insert(faults.end(), findings.faults.begin(), findings.faults.end());
  return findings.num_rows;
}

// A made-up set tells its kind; the lists of that kind cannot be missing but by a loss.
void RequireListsOfKind(const fs::path& root) {
  const fs::path file = root / kMadeUpFileName;
  if (!Exists(file)) return;
  const std::string kind = ReadTomlFile(file)["kind"].value_or(std::string());
  for (const auto& [name, kind_of_list] : {std::pair(kDemonstrationsFileName, "demonstrations"),
                                           std::pair(kHoldsFileName, "regrasp"),
                                           std::pair(kDemonstrationsFileName, "regrasp")}) {
    if (kind != kind_of_list || KindOf(root / name) != PathKind::kNothing) continue;
    throw Error({.path = (root / name).string(),
                 .reason = "is not there; " + std::string(kMadeUpFileName) +
                           " tells of a set of the kind " + kind,
                 .remedy = "copy it again, or run handcraft data synth " + kind +
                           " with the options in that file"});
  }
}

// Pictures beside listed ones that no list names.
void NoteUnlisted(const std::vector<fs::path>& listed,
                  const fs::path& root,
                  std::vector<Fault>& notes) {
  std::set<fs::path> known;
  std::set<fs::path> folders;
  for (const fs::path& path : listed) {
    if (path.empty()) continue;
    known.insert(path.lexically_normal());
    folders.insert(path.lexically_normal().parent_path());
  }
  std::vector<std::string> unlisted;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator it(root / folder, error), end; !error && it != end;
         it.increment(error)) {
      const fs::path path = folder / it->path().filename();
      if (IsNamedLikeAPicture(path) && !known.contains(path)) unlisted.push_back(path.string());
    }
  }
  if (unlisted.empty()) return;
  std::string reason = "is in no row of the list";
  if (unlisted.size() > 1) reason += ", the first of " + std::to_string(unlisted.size());
  notes.push_back({.path = *std::min_element(unlisted.begin(), unlisted.end()),
                   .reason = reason + ": nothing reads it",
                   .gravity = Gravity::kNote});
}

// The files that the rows name.
void AddFilesOf(const LabelledImage& item, std::vector<fs::path>& files) {
  files.insert(files.end(), {item.image, item.mask});
  for (const std::string_view column : kCompanions) files.emplace_back(item.Companion(column));
}
void AddFilesOf(const ObjectView& item, std::vector<fs::path>& files) {
  files.insert(files.end(), {item.image, item.object_mask, item.cloud, item.depth, item.scene});
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
  std::vector<fs::path> files;
  std::visit(
      [&](const auto& pictures) {
        checked.num_images = pictures.items.size();
        checked.faults = FindFaults(pictures, num_threads, progress);
        for (const auto& item : pictures.items) AddFilesOf(item, files);
      },
      set.pictures);
  CollectFaults(set.root(), checked.faults, [&] { RequireListsOfKind(set.root()); });
  NoteUnlisted(files, set.root(), checked.faults);
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
