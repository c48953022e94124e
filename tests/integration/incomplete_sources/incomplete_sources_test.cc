// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Each file of each format is taken away, emptied, and put in place of by a pipe and by a folder:
// what is missing is told in a note or refused, what is there and of no use is refused by its name.

#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "datasets/importers/bop.h"
#include "datasets/importers/coco.h"
#include "datasets/importers/coil.h"
#include "datasets/importers/cornell.h"
#include "datasets/importers/cvat.h"
#include "datasets/importers/eth80.h"
#include "datasets/importers/folders.h"
#include "datasets/importers/jacquard.h"
#include "datasets/importers/labelme.h"
#include "datasets/importers/umd.h"
#include "datasets/importers/view_set_import.h"
#include "datasets/importers/washington.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const fs::path kData = fs::path(HANDCRAFT_SOURCE_DIR) / "tests/data";
constexpr const char* kNoNote = "";

// A file of a tree; what is told when it is missing.
struct SourceFile {
  std::string name;
  std::string told;  // kNoNote: nothing, for no other picture has one
};

struct Format {
  std::string name;
  std::function<void(const fs::path& tree)> fill;  // two pictures at least
  std::function<SourceSet(const fs::path& tree)> list;
  bool makes_views = false;
  std::vector<SourceFile> files;
};

void PrintTo(const Format& format, std::ostream* out) { *out << format.name; }

void Copy(const fs::path& from, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::copy(from, to, fs::copy_options::recursive);
}

void FillCornell(const fs::path& tree) {
  Copy(kData / "cornell", tree);
  for (const char* number : {"0100", "0110", "0120", "0130", "0140", "0150"}) {
    WriteFileAtomically(tree / (std::string("pcd") + number + ".txt"),
                        "FIELDS x y z rgb index\nSIZE 4 4 4 4 4\nTYPE F F F F U\nWIDTH 1\n"
                        "HEIGHT 1\nPOINTS 1\nDATA ascii\n1500 0 -250 0 41\n");
  }
  WriteFileAtomically(tree / "grasp_type.csv", "image,grasp_type\npcd0100r.png,2\n");
}

void FillJacquard(const fs::path& tree) {
  Copy(kData / "jacquard", tree);
  for (const char* end : {"_RGB.png", "_grasps.txt"}) {
    Copy(tree / "1a2b" / (std::string("0_1a2b") + end),
         tree / "1a2b" / (std::string("1_1a2b") + end));
  }
}

void FillSaxena(const fs::path& tree) {
  for (const std::string name : {"a", "b"}) {
    Copy(kData / "saxena/mug/mug_0001.png", tree / (name + ".png"));
    Copy(kData / "saxena/mug/mug_0001_label.png", tree / (name + "_label.png"));
  }
}

void FillFolders(const fs::path& tree) {
  for (const std::string name : {"a.png", "b.png"}) {
    Copy(kData / "saxena/mug/mug_0001.png", tree / "images" / name);
    Copy(kData / "saxena/mug/mug_0001_label.png", tree / "masks" / name);
  }
}

void FillLabelme(const fs::path& tree) {
  Copy(kData / "labelme", tree);
  Copy(tree / "cup.png", tree / "pot.png");
  std::string text = ReadTextFile(tree / "cup.json");
  text.replace(text.find("cup.png"), 7, "pot.png");
  WriteFileAtomically(tree / "pot.json", text);
}

void FillCoco(const fs::path& tree) {
  Copy(kData / "coco/instances.json", tree / "instances.json");
  for (const char* name : {"pcd0100r.png", "pcd0110r.png"}) {
    Copy(kData / "cornell" / name, tree / name);
  }
}

void FillCvatMasks(const fs::path& tree) {
  Copy(kData / "cvat", tree);
  WriteFileAtomically(tree / "ImageSets/Segmentation/default.txt", "pcd0100r\npcd0110r\n");
  Copy(tree / "SegmentationClass/pcd0100r.png", tree / "SegmentationClass/pcd0110r.png");
  for (const char* name : {"pcd0100r.png", "pcd0110r.png"}) {
    Copy(kData / "cornell" / name, tree / "JPEGImages" / name);
  }
}

void FillCvatShapes(const fs::path& tree) {
  std::string images;
  for (const std::string name : {"pcd0100r.png", "pcd0110r.png"}) {
    Copy(kData / "cornell" / name, tree / "images" / name);
    images.append("<image name=\"").append(name).append("\" width=\"160\" height=\"120\">");
    images += "<box label=\"good\" xtl=\"1\" ytl=\"1\" xbr=\"9\" ybr=\"9\"/></image>";
  }
  WriteFileAtomically(tree / "annotations.xml", "<annotations>" + images + "</annotations>");
}

void FillUmd(const fs::path& tree) {
  Copy(kData / "umd/mug_01", tree / "mug_01");
  Copy(kData / "umd/mug_01", tree / "mug_02");
}

std::function<void(const fs::path& tree)> CopyOfViews(const std::string& name) {
  return [name](const fs::path& tree) { Copy(kData / "views" / name, tree); };
}

std::vector<Format> FormatsOfGrasps() {
  return {
      {.name = "cornell",
       .fill = FillCornell,
       .list = [](const fs::path& tree) { return ListCornell(tree, {}); },
       .files = {{"pcd0100r.png", "pcd0100cpos.txt: left out: no pcdNNNNr.png of this number"},
                 {"pcd0100cpos.txt", "pcd0100r.png: left out: no pcdNNNNcpos.txt of this number"},
                 {"pcd0100cneg.txt", "pcd0100r.png: imported without negative rectangles: no pcd"},
                 {"pcd0100.txt", "pcd0100r.png: imported without its cloud: no pcdNNNN.txt"},
                 {"grasp_type.csv", kNoNote}}},
      {.name = "jacquard",
       .fill = FillJacquard,
       .list = [](const fs::path& tree) { return ListJacquard(tree, {}); },
       .files = {{"1a2b/0_1a2b_RGB.png", "0_1a2b_grasps.txt: left out: no *_RGB.png beside it"},
                 {"1a2b/0_1a2b_grasps.txt", "0_1a2b_RGB.png: left out: no *_grasps.txt beside"}}},
      {.name = "umd",
       .fill = FillUmd,
       .list = [](const fs::path& tree) { return ListUmd(tree, UmdRoles()); },
       .files = {{"mug_01/mug_01_00000001_rgb.png", "_label.mat: left out: no *_rgb.jpg beside it"},
                 {"mug_01/mug_01_00000001_label.mat", "_rgb.png: left out: no *_label.mat or "}}}};
}

std::vector<Format> FormatsOfPairs() {
  const FoldersOptions saxena{.images = ".", .masks = ".", .mask_suffix = "_label"};
  const LabelRoles handle{.good = {"handle"}};
  return {
      {.name = "saxena",
       .fill = FillSaxena,
       .list = [=](const fs::path& tree) { return ListFolders(tree, saxena); },
       .files = {{"a.png", "a_label.png: left out: no picture: expected "},
                 {"a_label.png", "a.png: left out: no mask: expected "}}},
      {.name = "folders",
       .fill = FillFolders,
       .list = [](const fs::path& tree) { return ListFolders(tree, {}); },
       .files = {{"images/b.png", "masks/b.png: left out: no picture: expected "},
                 {"masks/b.png", "images/b.png: left out: no mask: expected "}}},
      {.name = "cvat_masks",
       .fill = FillCvatMasks,
       .list = [=](const fs::path& tree) { return ListCvat(tree, {.roles = handle}); },
       .files = {{"JPEGImages/pcd0100r.png",
                  "SegmentationClass/pcd0100r.png: left out: no picture of this mask in "},
                 {"SegmentationClass/pcd0110r.png", "pcd0110r.png: left out: no such mask, which"},
                 {"ImageSets/Segmentation/default.txt", "refused: no *.txt with names"},
                 {"labelmap.txt", "refused: neither labelmap.txt"}}}};
}

std::vector<Format> FormatsOfShapes() {
  return {{.name = "labelme",
           .fill = FillLabelme,
           .list = [](const fs::path& tree) { return ListLabelme(tree, {}); },
           .files = {{"cup.png", "cup.json: left out: the picture that it names is not there"},
                     {"cup.json", "cup.png: left out: no LabelMe file names this picture"}}},
          {.name = "coco",
           .fill = FillCoco,
           .list = [](const fs::path& tree) { return ListCoco(tree / "instances.json", {}); },
           .files = {{"pcd0110r.png", "pcd0110r.png: left out: no such file, which "},
                     {"instances.json", "refused: cannot open"}}},
          {.name = "cvat_shapes",
           .fill = FillCvatShapes,
           .list = [](const fs::path& tree) { return ListCvat(tree, {}); },
           .files = {{"images/pcd0110r.png", "images/pcd0110r.png: left out: no such file, which "},
                     {"annotations.xml", "refused: nor annotations.xml"}}}};
}

std::vector<Format> FormatsOfViews() {
  const std::string washington = "mug/mug_1/mug_1_1_1";
  return {
      {.name = "eth80",
       .fill = CopyOfViews("eth80"),
       .list = [](const fs::path& tree) { return ListEth80(tree, {}); },
       .makes_views = true,
       .files = {{"mug1/mug1-090-000.png", "mug1-090-000-map.png: left out: no picture OBJECT-PPP"},
                 {"mug1/maps/mug1-090-000-map.png", "mug1-090-000.png: left out: no silhouette"}}},
      // Nothing tells that a picture of these is missing: one file a view, and no list.
      {.name = "coil",
       .fill = CopyOfViews("coil"),
       .list = [](const fs::path& tree) { return ListCoil(tree, {}); },
       .makes_views = true,
       .files = {{"obj1__0.png", kNoNote}}},
      {.name = "washington",
       .fill = CopyOfViews("washington"),
       .list = ListWashington,
       .makes_views = true,
       .files = {{washington + "_crop.png", "_depthcrop.png: left out: no *_crop.png beside it"},
                 {washington + "_maskcrop.png", "_crop.png: left out: no *_maskcrop.png beside"},
                 {washington + "_depthcrop.png", "_crop.png: imported without its cloud: no "},
                 {washington + "_loc.txt", "_crop.png: imported without its cloud: no "},
                 {washington + "_pose.txt", "_crop.png: imported without its angle: no "}}},
      {.name = "bop",
       .fill = CopyOfViews("bop"),
       .list = [](const fs::path& tree) { return ListBop(tree, {}); },
       .makes_views = true,
       .files = {{"000001/rgb/000000.png", "rgb/000000.png: left out: no such picture of scene"},
                 {"000001/mask_visib/000000_000000.png", "_000000.png: left out: no such mask"},
                 {"000001/depth/000000.png", "rgb/000000.png: imported without its cloud: no "},
                 {"000001/scene_camera.json", "refused: scene_camera.json: cannot open"},
                 {"000001/scene_gt.json", "refused: no object to be seen; found 0 scenes"}}}};
}

class IncompleteSources : public ::testing::TestWithParam<Format> {
 protected:
  // A whole tree.
  void Refill() const {
    fs::remove_all(tree_);
    fs::remove_all(out_);
    GetParam().fill(tree_);
  }

  // What an import tells: its notes, or "refused: " and why.
  [[nodiscard]] std::vector<std::string> Told() const {
    std::vector<std::string> told;
    const ImportOptions options{
        .on_note = [&](const Fault& note) { told.push_back(note.path + ": " + note.reason); }};
    try {
      SourceSet source = GetParam().list(tree_);
      if (GetParam().makes_views) {
        ImportViews(std::move(source), out_, options);
      } else {
        ImportPictures(std::move(source), out_, options);
      }
    } catch (const Error& error) {
      EXPECT_FALSE(fs::exists(out_));
      return {std::string("refused: ") + error.what()};
    }
    EXPECT_TRUE(fs::exists(out_));
    return told;
  }

  testing::TemporaryDirectory folder_;
  fs::path tree_ = folder_ / "tree";
  fs::path out_ = folder_ / "out";
};

TEST_P(IncompleteSources, TellsNothingOfAWholeTree) {
  Refill();
  EXPECT_THAT(Told(), IsEmpty());
}

TEST_P(IncompleteSources, TellsOfEachMissingFile) {
  for (const SourceFile& file : GetParam().files) {
    Refill();
    ASSERT_TRUE(fs::remove(tree_ / file.name)) << file.name;
    constexpr std::string_view kRefused = "refused: ";
    const bool is_refused = file.told.starts_with(kRefused);
    const std::string text = is_refused ? file.told.substr(kRefused.size()) : file.told;
    if (file.told == kNoNote) {
      EXPECT_THAT(Told(), IsEmpty()) << file.name;
    } else {
      const std::vector<std::string> told = Told();
      EXPECT_THAT(told, Contains(HasSubstr(text))) << file.name;
      EXPECT_EQ(told.at(0).starts_with(kRefused), is_refused) << file.name;
    }
  }
}

TEST_P(IncompleteSources, NamesWhatIsOfNoUse) {
  const std::vector<std::pair<std::string, std::function<void(const fs::path&)>>> adversaries = {
      {"file is empty", [](const fs::path& path) { WriteFileAtomically(path, ""); }},
      {"is a pipe or a device; a file is due",
       [](const fs::path& path) { ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0); }},
      {"is a folder", [](const fs::path& path) { fs::create_directory(path); }}};
  for (const SourceFile& file : GetParam().files) {
    for (const auto& [reason, put] : adversaries) {
      Refill();
      ASSERT_TRUE(fs::remove(tree_ / file.name)) << file.name;
      put(tree_ / file.name);
      const std::vector<std::string> told = Told();
      ASSERT_THAT(told, ::testing::SizeIs(1)) << file.name;
      EXPECT_THAT(told[0],
                  AllOf(HasSubstr("refused: " + (tree_ / file.name).string()),
                        AnyOf(HasSubstr(reason), HasSubstr("cannot read: Is a directory"))));
    }
  }
}

std::string NameOf(const ::testing::TestParamInfo<Format>& format) { return format.param.name; }

INSTANTIATE_TEST_SUITE_P(Grasps, IncompleteSources, ::testing::ValuesIn(FormatsOfGrasps()), NameOf);
INSTANTIATE_TEST_SUITE_P(Pairs, IncompleteSources, ::testing::ValuesIn(FormatsOfPairs()), NameOf);
INSTANTIATE_TEST_SUITE_P(Shapes, IncompleteSources, ::testing::ValuesIn(FormatsOfShapes()), NameOf);
INSTANTIATE_TEST_SUITE_P(Views, IncompleteSources, ::testing::ValuesIn(FormatsOfViews()), NameOf);

}  // namespace
}  // namespace handcraft::datasets
