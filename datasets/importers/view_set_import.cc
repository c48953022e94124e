// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/view_set_import.h"

#include <string>
#include <utility>
#include <vector>

#include "datasets/close_up.h"
#include "datasets/formats/fault.h"
#include "datasets/formats/mask_picture.h"
#include "datasets/importers/import_plan.h"
#include "datasets/importers/source_tree.h"
#include "datasets/importers/staging_folder.h"
#include "datasets/parallel_reporting.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

ObjectView Describe(const SourcePicture& picture, const std::string& licence) {
  return {.image = "images/" + picture.image,
          .object_mask = "object_masks/" + picture.mask,
          .cloud = CloudPath(picture),
          .object_class = picture.object_class,
          .instance = picture.instance,
          .angle_deg = picture.angle_deg,
          .split = picture.split,
          .licence = licence};
}

// Returns what is worth knowing about it.
std::vector<Fault> WriteView(const SourcePicture& picture,
                             const ObjectView& view,
                             const fs::path& root) {
  const Image image = CopyPicture(picture, root / view.image);
  const PixelSize size = {image.width(), image.height()};
  const Image mask = picture.make_mask(image.width(), image.height());
  RequireSameSize(picture.path, "the object mask", {mask.width(), mask.height()}, size);
  perception::WritePng(root / view.object_mask, mask);
  if (picture.make_cloud) WriteCloud(picture, size, root / view.cloud);
  if (FindBox(mask, kObject)) return {};
  return {{.path = view.object_mask,
           .reason = "no pixel of an object (255): handcraft data check refuses the set",
           .gravity = Gravity::kNote,
           .remedy = "leave the picture out"}};
}

}  // namespace

ViewSet ImportViews(SourceSet source, const fs::path& out, const ImportOptions& options) {
  PlanImport(source, options);
  const std::vector<SourcePicture>& pictures = source.pictures;
  StagingFolder staging(out);
  ViewSet set{.root = staging.path(), .items = {}};
  std::vector<std::string> files;
  for (const SourcePicture& picture : pictures) {
    set.items.push_back(Describe(picture, options.licence));
    const ObjectView& view = set.items.back();
    files.insert(files.end(), {view.image, view.object_mask});
    if (!view.cloud.empty()) files.push_back(view.cloud);
  }
  AddFoldersOf(staging, files);
  std::vector<std::vector<Fault>> notes(pictures.size());
  ParallelForReporting(
      pictures.size(),
      options.num_threads,
      options.progress,
      "importing views",
      [&](std::size_t i) { notes[i] = WriteView(pictures[i], set.items[i], set.root); });
  WriteViews(set);
  staging.MoveToTarget();
  set.root = out;
  TellNotes(notes, options);
  return set;
}

}  // namespace handcraft::datasets
