// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_data.h"

#include <string>

#include <fmt/format.h>

#include "datasets/formats/listing_rules.h"
#include "datasets/synthetic/demonstrations.h"
#include "datasets/view_folds.h"
#include "lib/core/error.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

datasets::ViewSet MakeSet(const ViewSource& source,
                          synthetic::Family family,
                          int number,
                          const fs::path& folder,
                          int num_threads,
                          const Progress& progress) {
  return synthetic::MakeViewSet(folder,
                                {.kind = source.kind,
                                 .family = family,
                                 .num_views = source.num_views,
                                 .sensor = source.sensor,
                                 .seed = source.seed + static_cast<std::uint64_t>(number),
                                 .num_threads = num_threads,
                                 .progress = progress})
      .set;
}

// Views with poses shown for them, in a folder of their own.
datasets::ViewSet MakeShown(const ViewSource& source,
                            const fs::path& folder,
                            int num_threads,
                            const Progress& progress) {
  static_cast<void>(synthetic::MakeDemonstrations(folder,
                                                  {.views = {.family = source.families.front(),
                                                             .num_views = source.num_views,
                                                             .sensor = source.sensor,
                                                             .seed = source.seed,
                                                             .num_threads = num_threads,
                                                             .progress = progress},
                                                   .poses_per_view = source.num_poses}));
  return datasets::ReadViewSet(folder);
}

// The view with its paths as seen from the folder above its set's.
datasets::ObjectView Below(const std::string& folder, datasets::ObjectView view) {
  for (std::string* path :
       {&view.image, &view.object_mask, &view.cloud, &view.depth, &view.scene}) {
    if (!path->empty()) *path = folder + "/" + *path;
  }
  return view;
}

datasets::ViewSet ReadFolder(const ViewSource& source) {
  datasets::ViewSet set = datasets::ReadViewSet(source.folder);
  if (source.split.empty()) return set;
  std::erase_if(set.items,
                [&](const datasets::ObjectView& view) { return view.split != source.split; });
  if (!set.items.empty()) return set;
  throw Error({.path = (set.root / datasets::kViewsFileName).string(),
               .reason = fmt::format("no view is of the split \"{}\"", source.split)});
}

}  // namespace

datasets::ViewSet ProvideViews(const ViewSource& source,
                               const fs::path& made_folder,
                               int num_threads,
                               const Progress& progress) {
  if (!source.folder.empty()) return ReadFolder(source);
  if (source.num_poses > 0) return MakeShown(source, made_folder, num_threads, progress);
  fs::create_directories(made_folder);
  datasets::ViewSet all{.root = made_folder, .items = {}};
  for (int number = 0; number < source.num_sets; ++number) {
    const std::string ending = source.num_sets > 1 ? fmt::format(" {}", number + 1) : "";
    for (const synthetic::Family family : source.families) {
      const std::string folder = fmt::format("{}_{}", synthetic::NameOf(family), number + 1);
      const datasets::ViewSet set =
          MakeSet(source, family, number, made_folder / folder, num_threads, progress);
      for (const datasets::ObjectView& item : set.items) {
        all.items.push_back(Below(folder, item));
        all.items.back().object_class += ending;
        all.items.back().instance += ending;
      }
    }
  }
  return all;
}

datasets::ViewSet OnlyFirstClasses(const datasets::ViewSet& set, std::size_t num_classes) {
  if (num_classes == 0) return set;
  const datasets::ViewClasses classes = datasets::ClassesOf(set);
  if (num_classes > classes.names.size()) {
    throw Error(
        {.kind = Error::Kind::kUsage,
         .reason = fmt::format(
             "num_classes is {}, and there are {} classes", num_classes, classes.names.size())});
  }
  datasets::ViewSet first{.root = set.root, .items = {}};
  for (std::size_t i = 0; i < set.items.size(); ++i) {
    if (classes.values[i] < num_classes) first.items.push_back(set.items[i]);
  }
  return first;
}

}  // namespace handcraft::experiments
