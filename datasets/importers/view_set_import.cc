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
#include "datasets/importers/omissions.h"
#include "datasets/importers/source_tree.h"
#include "datasets/importers/staging_folder.h"
#include "datasets/parallel_reporting.h"
#include "lib/core/error.h"
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

// Returns false when no object is seen; then the picture may be there, but nothing else is.
bool WriteView(const SourcePicture& picture, const ObjectView& view, const fs::path& root) {
  const Image image = CopyPicture(picture, root / view.image);
  if (image.empty()) return false;
  const PixelSize size = {image.width(), image.height()};
  const Image mask = picture.make_mask(image.width(), image.height());
  RequireSameSize(picture.path, "the object mask", {mask.width(), mask.height()}, size);
  if (!FindBox(mask, kObject)) return false;
  perception::WritePng(root / view.object_mask, mask);
  if (picture.make_cloud) WriteCloud(picture, size, root / view.cloud);
  return true;
}

// Takes those out that show no object, with what was written of them. Returns the notes on it.
std::vector<Fault> LeaveOutEmptyViews(const std::vector<SourcePicture>& pictures,
                                      const std::vector<char>& shows_object,
                                      const StagingFolder& staging,
                                      ViewSet& set) {
  Omissions omissions;
  std::vector<ObjectView> kept;
  kept.reserve(set.items.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    ObjectView& view = set.items[i];
    if (shows_object[i] != 0) {
      kept.push_back(std::move(view));
      continue;
    }
    for (const std::string& file : {view.image, view.object_mask, view.cloud}) {
      if (!file.empty()) staging.Remove(file);
    }
    const bool is_file = !pictures[i].make_image && !pictures[i].embedded;
    omissions.LeaveOut(is_file ? pictures[i].path : fs::path(view.image),
                       "no object is seen: its mask has no pixel of one");
  }
  set.items = std::move(kept);
  return omissions.Notes();
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
  std::vector<char> shows_object(pictures.size());
  ParallelForReporting(pictures.size(),
                       options.num_threads,
                       options.progress,
                       "importing views",
                       [&](std::size_t i) {
                         shows_object[i] = WriteView(pictures[i], set.items[i], set.root) ? 1 : 0;
                       });
  const std::vector<Fault> notes = LeaveOutEmptyViews(pictures, shows_object, staging, set);
  if (set.items.empty()) {
    throw Error({.path = pictures.front().path.string(),
                 .reason = "no object is seen in this view nor in the others: no mask has a pixel "
                           "of one",
                 .remedy = "look at the masks of the source"});
  }
  WriteViews(set);
  staging.MoveToTarget();
  set.root = out;
  TellNotes(source.notes, {notes}, options);
  return set;
}

}  // namespace handcraft::datasets
