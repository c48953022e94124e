// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/synthetic/set_lists.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "lib/core/error.h"

namespace handcraft::synthetic {
namespace {

// What stands there; nothing when it cannot be read.
template <class Set>
std::optional<Set> ReadIfSound(Set (*read)(const std::filesystem::path&),
                               const std::filesystem::path& root) {
  try {
    return read(root);
  } catch (const Error&) {
    return std::nullopt;
  }
}

// Takes the splits of the list that stands there over, if it lists the same pictures.
bool TakeSplits(const std::optional<datasets::ViewSet>& there, datasets::ViewSet& set) {
  if (!there || there->items.size() != set.items.size()) return false;
  datasets::ViewSet divided = set;
  for (std::size_t i = 0; i < set.items.size(); ++i) divided.items[i].split = there->items[i].split;
  if (divided.items != there->items) return false;
  set = divided;
  return true;
}

// Pictures with their masks, which a person who edits the manifest may have put in another order.
std::set<std::pair<std::string, std::string>> PicturesOf(const datasets::LabelledImageSet& set) {
  std::set<std::pair<std::string, std::string>> pictures;
  for (const datasets::LabelledImage& item : set.items) pictures.emplace(item.image, item.mask);
  return pictures;
}

template <class Set>
bool TellsTheSame(const std::optional<Set>& there, const Set& set) {
  return there && Fingerprint(*there) == Fingerprint(set);
}

}  // namespace

void WriteList(datasets::LabelledImageSet& set, Written& written) {
  std::optional<datasets::LabelledImageSet> there =
      ReadIfSound(datasets::ReadLabelledImageSet, set.root);
  if (there && PicturesOf(*there) == PicturesOf(set)) {
    set = *std::move(there);
    return;
  }
  datasets::WriteManifest(set);
  ++written.num_lists;
}

void WriteList(datasets::ViewSet& set, Written& written) {
  if (TakeSplits(ReadIfSound(datasets::ReadViewSet, set.root), set)) return;
  datasets::WriteViews(set);
  ++written.num_lists;
}

void WriteList(const datasets::DemonstrationSet& set, Written& written) {
  if (TellsTheSame(ReadIfSound(datasets::ReadDemonstrationSet, set.root), set)) return;
  datasets::WriteDemonstrations(set);
  ++written.num_lists;
}

void WriteList(const datasets::HoldSet& set, Written& written) {
  if (TellsTheSame(ReadIfSound(datasets::ReadHoldSet, set.root), set)) return;
  datasets::WriteHolds(set);
  ++written.num_lists;
}

}  // namespace handcraft::synthetic
