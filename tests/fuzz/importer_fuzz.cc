// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Files of others from anywhere: what the importers read ends in a result or in handcraft::Error,
// and in nothing else. The first byte chooses the reader, the rest is the file.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/labelled_image_set.h"
#include "datasets/formats/mat_array.h"
#include "datasets/formats/npy.h"
#include "datasets/formats/npy_pictures.h"
#include "datasets/formats/organised_cloud.h"
#include "datasets/formats/table.h"
#include "datasets/formats/view_set.h"
#include "datasets/importers/base64.h"
#include "datasets/importers/bop.h"
#include "datasets/importers/coco.h"
#include "datasets/importers/coco_runs.h"
#include "datasets/importers/coil.h"
#include "datasets/importers/cornell.h"
#include "datasets/importers/cornell_rectangles.h"
#include "datasets/importers/cvat.h"
#include "datasets/importers/cvat_shapes.h"
#include "datasets/importers/eth80.h"
#include "datasets/importers/folders.h"
#include "datasets/importers/jacquard.h"
#include "datasets/importers/labelme.h"
#include "datasets/importers/umd.h"
#include "datasets/importers/washington.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/fuzz/fuzzed_file.h"

namespace handcraft::datasets {
namespace {

using testing::FuzzedFile;
using testing::Require;

// In which the file has this name, and a picture lies that it may name.
std::filesystem::path FolderWithPicture(const FuzzedFile& file, const std::string& name) {
  std::filesystem::path folder = file.FolderOf(name);
  if (!std::filesystem::exists(folder / "a.png")) {
    std::ofstream picture(folder / "a.png");
    Require((picture << "not read").good());
  }
  return folder;
}

// Beside views.csv with one view, in which the file has this name.
std::filesystem::path FolderWithView(const FuzzedFile& file, const std::string& name) {
  std::filesystem::path folder = file.FolderOf(name);
  if (!std::filesystem::exists(folder / "views.csv")) {
    std::ofstream views(folder / "views.csv");
    Require((views << "image,class,instance,angle_deg\na.png,mug,m1,30\n").good());
  }
  return folder;
}

// Pictures that are 6 × 4 are drawn.
void MakeMasks(const SourceSet& source) {
  for (const SourcePicture& picture : source.pictures) {
    const Image mask = picture.make_mask(6, 4);
    Require(mask.width() == 6 && mask.height() == 4);
    if (picture.find_notes) static_cast<void>(picture.find_notes(6, 4));
    for (const std::uint8_t value : mask.values()) {
      Require(value == kMaskGood || value == kMaskBad || value == kMaskDontCare);
    }
  }
}

void MakeMaskOf(const std::vector<GraspRectangle>& rectangles) {
  if (rectangles.size() > 8) return;  // enough; each costs time
  Require(MakeGraspMask(20, 15, rectangles, {}, {}).width() == 20);
}

void ReadCoco(const FuzzedFile& file) {
  MakeMasks(ListCoco(file.path(), {.images = FolderWithPicture(file, "a.json")}));
}

void ReadLabelme(const FuzzedFile& file) {
  MakeMasks(ListLabelme(FolderWithPicture(file, "a.json"), {}));
}

void ReadCvatShapes(const FuzzedFile& file) {
  MakeMasks(ListCvatShapes(file.path(), {.images = FolderWithPicture(file, "a.json")}));
}

void ReadCvatMasks(const FuzzedFile& file) {
  static_cast<void>(ListCvat(FolderWithPicture(file, "labelmap.txt"), {}));
}

void ReadMat(const FuzzedFile& file) {
  const MatArray array = ReadMatArray(file.path(), "gt_label");
  std::size_t count = 1;
  for (const std::size_t size : array.dimensions) count *= size;
  Require(array.dimensions.size() >= 2 && array.values.size() == count);
}

void ReadCloud(const FuzzedFile& file) {
  const OrganisedCloud cloud = ReadPcd(file.path());
  Require(cloud.points.size() ==
          static_cast<std::size_t>(cloud.width) * static_cast<std::size_t>(cloud.height));
  if (cloud.height == 1) Require(ReadCloudOfPicture(file.path(), {3, 2}).points.size() == 6);
}

void ReadRectangles(const FuzzedFile& file) { MakeMaskOf(ReadCornellRectangles(file.path())); }

void ReadGrasps(const FuzzedFile& file) { MakeMaskOf(ReadJacquardGrasps(file.path())); }

void ReadMatrix(const FuzzedFile& file) {
  const NpyMatrix matrix = ReadNpy(file.path());
  Require(matrix.values.size() == matrix.rows * matrix.columns);
}

void ReadPictures(const FuzzedFile& file) {
  for (const Image& picture : ReadNpyPictures(file.path())) Require(!picture.empty());
}

void ReadCsvTable(const FuzzedFile& file) {
  const Table table = ReadTable(file.path(), "label");
  Require(table.values.size() == table.num_rows * table.columns.size());
}

void ReadManifest(const FuzzedFile& file) {
  static_cast<void>(ReadLabelledImageSet(file.FolderOf("manifest.csv")));
}

void ReadViews(const FuzzedFile& file) {
  static_cast<void>(ReadViewSet(file.FolderOf("views.csv")));
}

void ReadDemonstrations(const FuzzedFile& file) {
  const auto root = FolderWithView(file, "demonstrations.csv");
  const RowFindings findings = CheckDemonstrations(root);
  Require(findings.faults.size() <= findings.num_rows + 1);
  static_cast<void>(ReadDemonstrationSet(root));
  for (const Fault& fault : findings.faults) Require(fault.reason.starts_with("the same row as"));
}

void ReadHolds(const FuzzedFile& file) {
  const auto root = FolderWithView(file, "holds.csv");
  const RowFindings findings = CheckHolds(root);
  static_cast<void>(ReadHoldSet(root));
  for (const Fault& fault : findings.faults) Require(fault.reason.starts_with("the same row as"));
}

// Files of a format that finds them by their names, two that belong together at least.
struct SourceTree {
  SourceSet (*list)(const std::filesystem::path& tree);
  std::array<const char*, 5> names;  // empty: no more
};
constexpr auto kTrees = std::to_array<SourceTree>(
    {{[](const auto& tree) { return ListCornell(tree, {}); },
      {"pcd0100r.png", "pcd0100cpos.txt", "pcd0100cneg.txt", "pcd0100.txt", "grasp_type.csv"}},
     {[](const auto& tree) { return ListJacquard(tree, {}); },
      {"0_a_RGB.png", "0_a_grasps.txt", "1_a_RGB.png", "1_a_grasps.txt", ""}},
     {ListWashington,
      {"a_1_1_1_crop.png",
       "a_1_1_1_maskcrop.png",
       "a_1_1_1_depthcrop.png",
       "a_1_1_1_loc.txt",
       "a_1_1_1_pose.txt"}},
     {[](const auto& tree) { return ListEth80(tree, {}); },
      {"a1-090-000.png",
       "maps/a1-090-000-map.png",
       "a1-090-022.png",
       "maps/a1-090-022-map.png",
       ""}},
     {[](const auto& tree) { return ListUmd(tree, UmdRoles()); },
      {"a_rgb.png", "a_label.mat", "a_label_rank.mat", "b_rgb.jpg", ""}},
     {[](const auto& tree) { return ListFolders(tree, {}); },
      {"images/a.png", "masks/a.png", "images/b.jpg", "masks/b.png", ""}},
     {[](const auto& tree) { return ListCoil(tree, {}); },
      {"obj1__0.png", "obj1__1.png", "", "", ""}},
     {[](const auto& tree) { return ListLabelme(tree, {}); },
      {"a.json", "a.png", "b.json", "b.png", ""}},
     {[](const auto& tree) { return ListBop(tree, {}); },
      {"scene_gt.json",
       "scene_camera.json",
       "rgb/000000.png",
       "mask_visib/000000_000000.png",
       "depth/000000.png"}}});

// Puts nothing there, an empty file, a folder, a link that leads nowhere, or a file of these bytes.
void PutOneOf(std::uint8_t choice, std::string_view bytes, const std::filesystem::path& path) {
  std::filesystem::create_directories(path.parent_path());
  switch (choice % 8) {
    case 0:
      return;
    case 1:
      return Require(std::ofstream(path).good());
    case 2:
      return static_cast<void>(std::filesystem::create_directory(path));
    case 3:
      return std::filesystem::create_symlink("nowhere", path);
    default:
      break;
  }
  std::ofstream file(path, std::ios::binary);
  Require(file.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).good());
}

// The first byte chooses the tree, the next ones what stands at each name, the rest is in the
// files.
void ListTree(const FuzzedFile& file) {
  const std::string bytes = ReadTextFile(file.path());
  if (bytes.empty()) return;
  const SourceTree& tree = kTrees[static_cast<std::uint8_t>(bytes[0]) % kTrees.size()];
  const std::filesystem::path folder = file.FolderOf("tree") / "source";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  const std::size_t num_choices = tree.names.size() + 1;
  const std::string_view rest = std::string_view(bytes).substr(std::min(num_choices, bytes.size()));
  for (std::size_t i = 0; i < tree.names.size() && tree.names[i][0] != '\0'; ++i) {
    const char choice = i + 1 < bytes.size() ? bytes[i + 1] : '\0';
    PutOneOf(static_cast<std::uint8_t>(choice), rest, folder / tree.names[i]);
  }
  const SourceSet source = tree.list(folder);
  Require(!source.pictures.empty());
  for (const Fault& note : source.notes) Require(!note.path.empty() && !note.reason.empty());
}

constexpr auto kReaders = std::to_array<void (*)(const FuzzedFile&)>({ReadCoco,
                                                                      ReadLabelme,
                                                                      ReadCvatShapes,
                                                                      ReadCvatMasks,
                                                                      ReadMat,
                                                                      ReadCloud,
                                                                      ReadRectangles,
                                                                      ReadGrasps,
                                                                      ReadMatrix,
                                                                      ReadCsvTable,
                                                                      ReadManifest,
                                                                      ReadViews,
                                                                      ReadDemonstrations,
                                                                      ReadHolds,
                                                                      ReadPictures,
                                                                      ListTree});

// Texts within files.
void Decode(std::string_view text) {
  const auto bytes = DecodeBase64(text);
  Require(!bytes || bytes->size() <= text.size());
  const auto runs = DecodeCocoRuns(text);
  Require(!runs || runs->size() <= text.size());
}

void ReadOne(std::size_t reader, std::string_view bytes) {
  static const FuzzedFile kFile;
  if (reader == kReaders.size()) {
    Decode(bytes);
    return;
  }
  kFile.Fill(bytes);
  try {
    kReaders[reader](kFile);
  } catch (const Error& error) {
    Require(error.what()[0] != '\0');
  }
}

}  // namespace
}  // namespace handcraft::datasets

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using handcraft::datasets::kReaders;
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  handcraft::datasets::ReadOne(data[0] % (kReaders.size() + 1), bytes);
  return 0;
}
