// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_data.h"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lib/core/error.h"
#include "lib/core/sha256.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

std::vector<datasets::ViewSet> MakeSets(const ViewSource& source,
                                        const fs::path& made_folder,
                                        int num_threads,
                                        const Progress& progress) {
  std::vector<datasets::ViewSet> sets;
  for (int number = 1; number <= source.num_sets; ++number) {
    for (const synthetic::Family family : source.families) {
      const fs::path folder = made_folder / fmt::format("{}_{}", synthetic::NameOf(family), number);
      fs::create_directories(made_folder);
      sets.push_back(
          synthetic::MakeViewSet(folder,
                                 {.kind = source.kind,
                                  .family = family,
                                  .num_views = source.num_views,
                                  .sensor = source.sensor,
                                  .seed = source.seed + static_cast<std::uint64_t>(number - 1),
                                  .num_threads = num_threads,
                                  .progress = progress})
              .set);
    }
  }
  return sets;
}

}  // namespace

const datasets::ObjectView& ViewData::View(std::size_t number) const {
  for (const datasets::ViewSet& set : sets) {
    if (number < set.items.size()) return set.items[number];
    number -= set.items.size();
  }
  return sets.at(sets.size()).items.front();  // throws std::out_of_range
}

ViewData ProvideViews(const ViewSource& source,
                      const fs::path& made_folder,
                      int num_threads,
                      const Progress& progress) {
  ViewData data;
  if (source.folder.empty()) {
    data.sets = MakeSets(source, made_folder, num_threads, progress);
  } else {
    data.sets.push_back(datasets::ReadViewSet(source.folder));
  }
  const std::size_t num_families = std::max<std::size_t>(source.families.size(), 1);
  std::string fingerprints;  // a line a set
  for (std::size_t i = 0; i < data.sets.size(); ++i) {
    const std::string ending =
        source.num_sets > 1 ? fmt::format(" {}", i / num_families + 1) : std::string();
    for (const datasets::ObjectView& view : data.sets[i].items) {
      data.labels.push_back(view.object_class + ending);
      if (std::find(data.classes.begin(), data.classes.end(), data.labels.back()) ==
          data.classes.end()) {
        data.classes.push_back(data.labels.back());
      }
    }
    fingerprints += datasets::Fingerprint(data.sets[i]) + "\n";
  }
  data.fingerprint =
      Sha256Hex({reinterpret_cast<const std::uint8_t*>(fingerprints.data()), fingerprints.size()});
  return data;
}

std::vector<std::uint32_t> LabelNumbers(const std::vector<std::string>& labels,
                                        std::span<const std::string> classes) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(labels.size());
  for (const std::string& label : labels) {
    const auto found = std::find(classes.begin(), classes.end(), label);
    if (found == classes.end()) {
      throw Error({.reason = fmt::format("the class \"{}\" is none of those that were learnt: {}",
                                         label,
                                         fmt::join(classes, ", ")),
                   .remedy = "say in [association] which of them is right for it"});
    }
    numbers.push_back(static_cast<std::uint32_t>(found - classes.begin()));
  }
  return numbers;
}

}  // namespace handcraft::experiments
