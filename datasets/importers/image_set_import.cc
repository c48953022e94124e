// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/image_set_import.h"

#include <string>
#include <utility>
#include <vector>

#include "datasets/formats/mask_picture.h"
#include "datasets/importers/import_plan.h"
#include "datasets/importers/rectangle_list.h"
#include "datasets/importers/source_tree.h"
#include "datasets/importers/staging_folder.h"
#include "datasets/labelled_image_faults.h"
#include "datasets/parallel_reporting.h"
#include "lib/perception/image_io.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;

LabelledImage Describe(const SourcePicture& picture, const std::string& licence) {
  LabelledImage item{.image = "images/" + picture.image,
                     .mask = "masks/" + picture.mask,
                     .object_class = picture.object_class,
                     .instance = picture.instance,
                     .split = picture.split,
                     .licence = licence};
  if (picture.make_cloud) item.others[std::string(kCloud)] = CloudPath(picture);
  return item;
}

// Returns what is worth knowing about its labels.
std::vector<Fault> WritePicture(const SourcePicture& picture,
                                const LabelledImage& item,
                                const fs::path& root) {
  const Image image = CopyPicture(picture, root / item.image);
  const PixelSize size = {image.width(), image.height()};
  const Image mask = picture.make_mask(image.width(), image.height());
  RequireSameSize(picture.path, "the mask", {mask.width(), mask.height()}, size);
  perception::WritePng(root / item.mask, mask);
  if (picture.make_cloud) WriteCloud(picture, size, root / item.Companion(kCloud));
  std::vector<Fault> notes;
  if (picture.find_notes) notes = picture.find_notes(image.width(), image.height());
  const std::vector<Fault> on_mask = NotesOnMask(item.mask, mask);
  notes.insert(notes.end(), on_mask.begin(), on_mask.end());
  return notes;
}

// rectangles.csv, if any picture has some.
void WriteRectanglesOf(const std::vector<SourcePicture>& pictures, const LabelledImageSet& set) {
  std::vector<RectanglesOfImage> list;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (!pictures[i].read_rectangles) continue;
    list.push_back({.image = set.items[i].image, .rectangles = pictures[i].read_rectangles()});
  }
  if (!list.empty()) WriteRectangles(set.root, list);
}

}  // namespace

LabelledImageSet ImportPictures(SourceSet source,
                                const fs::path& out,
                                const ImportOptions& options) {
  PlanImport(source, options);
  const std::vector<SourcePicture>& pictures = source.pictures;
  StagingFolder staging(out);
  LabelledImageSet set{.root = staging.path(), .items = {}};
  std::vector<std::string> files;
  for (const SourcePicture& picture : pictures) {
    set.items.push_back(Describe(picture, options.licence));
    const LabelledImage& item = set.items.back();
    files.insert(files.end(), {item.image, item.mask});
    if (picture.make_cloud) files.push_back(item.Companion(kCloud));
  }
  AddFoldersOf(staging, files);
  std::vector<std::vector<Fault>> notes(pictures.size());
  ParallelForReporting(
      pictures.size(),
      options.num_threads,
      options.progress,
      "importing pictures",
      [&](std::size_t i) { notes[i] = WritePicture(pictures[i], set.items[i], set.root); });
  WriteRectanglesOf(pictures, set);
  WriteManifest(set);
  staging.MoveToTarget();
  set.root = out;
  TellNotes(source.notes, notes, options);
  return set;
}

}  // namespace handcraft::datasets
