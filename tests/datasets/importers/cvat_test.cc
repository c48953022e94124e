// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cvat.h"

#include <string>

#include "tests/datasets/importers/importer_test.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kLabelMap =
    "# label:color_rgb:parts:actions\r\nbackground:0,0,0::\n\nhandle:250,50,83::\nblur:9,8,7::\n";

// As CVAT writes it: two pictures of 3 × 1, their pixels background, handle, blur.
class ListCvatTest : public ImporterTest {
 protected:
  void SetUp() override {
    WriteText("labelmap.txt", kLabelMap);
    WriteText("ImageSets/Segmentation/default.txt", "mug/b ü,\"\r\na\n");
    for (const std::string name : {"a", "mug/b ü,\""}) {
      WriteImage("JPEGImages/" + name + ".png", 3, 1);
      WriteMask(name, {{0, 0, 0}, {83, 50, 250}, {7, 8, 9}});
    }
  }
  // Colours are blue, green, red, as in memory.
  void WriteMask(const std::string& name,
                 const std::vector<std::array<std::uint8_t, 3>>& colours) const {
    Image mask(static_cast<int>(colours.size()), 1, 3);
    for (int u = 0; u < mask.width(); ++u) {
      for (int channel = 0; channel < 3; ++channel) {
        mask.At(u, 0, channel) =
            colours[static_cast<std::size_t>(u)][static_cast<std::size_t>(channel)];
      }
    }
    WriteImage("SegmentationClass/" + name + ".png", mask);
  }
  [[nodiscard]] std::string Refusal(const CvatOptions& options = {.roles = {{"handle"}}}) const {
    return RefusalOf([&] { return ListCvat(tree_, options); });
  }
};

TEST_F(ListCvatTest, ReadsAnExport) {
  const SourceSet source = ListCvat(tree_, {.roles = {.good = {"handle"}, .dont_care = {"blur"}}});
  ASSERT_THAT(source.pictures, SizeIs(2));
  EXPECT_EQ(source.pictures[1].image, "mug/b ü,\".png");
  EXPECT_EQ(source.pictures[1].mask, "mug/b ü,\".png");
  EXPECT_EQ(source.pictures[1].object_class, "mug");
  EXPECT_EQ(source.pictures[1].instance, "mug/b ü,\"");
  const LabelledImageSet set = ImportPictures(source, out_, {});
  EXPECT_EQ(ReadMask(set, 0).values(), (std::vector<std::uint8_t>{0, 255, 128}));
  EXPECT_THAT(FindFaults(ReadLabelledImageSet(out_)), IsEmpty());
}

TEST_F(ListCvatTest, TakesLabelsWithoutARoleAndBlackForBad) {
  WriteText("labelmap.txt", "handle:250,50,83::\nblur:9,8,7::");
  const SourceSet source = ListCvat(tree_, {.roles = {{"handle"}}});
  EXPECT_EQ(source.pictures[0].make_mask(3, 1).values(), (std::vector<std::uint8_t>{0, 255, 0}));
  WriteImage("SegmentationClass/a.png", Image(3, 1));  // gray
  EXPECT_EQ(source.pictures[0].make_mask(3, 1).values(), (std::vector<std::uint8_t>{0, 0, 0}));
  WriteText("labelmap.txt", "table:0,0,0::\nhandle:250,50,83::\nblur:9,8,7::");
  EXPECT_EQ(ListCvat(tree_, {.roles = {.good = {"table"}}}).pictures[0].make_mask(3, 1).At(0, 0),
            255);
}

TEST_F(ListCvatTest, FindsPicturesInAnotherFolder) {
  fs::rename(tree_ / "JPEGImages", folder_ / "photos");
  EXPECT_THAT(Refusal(), HasSubstr("JPEGImages: no folder of the pictures"));
  EXPECT_THAT(ListCvat(tree_, {.images = folder_ / "photos", .roles = {{"handle"}}}).pictures,
              SizeIs(2));
  fs::remove(folder_ / "photos/a.png");
  const SourceSet source = ListCvat(tree_, {.images = folder_ / "photos", .roles = {{"handle"}}});
  EXPECT_THAT(source.pictures, SizeIs(1));
  ASSERT_THAT(source.notes, SizeIs(1));
  EXPECT_EQ(source.notes[0].path, (tree_ / "SegmentationClass/a.png").string());
  EXPECT_THAT(source.notes[0].reason, HasSubstr("left out: no picture of this mask in "));
}

TEST_F(ListCvatTest, RefusesAWrongTree) {
  EXPECT_THAT(Refusal({}),
              HasSubstr("nothing is labelled 'good'; there are: 'background', 'blur'"));
  const std::string names = "ImageSets/Segmentation/default.txt";
  for (const char* name : {"../a", "/etc/hostname", "..\\a"}) {
    WriteText(names, name);
    EXPECT_THAT(Refusal(), HasSubstr("leads out of")) << name;
  }
  WriteText(names, "c");
  EXPECT_THAT(Refusal(), HasSubstr("SegmentationClass/c.png: left out: no such mask, which "));
  WriteText(names, "\n \n");
  EXPECT_THAT(Refusal(), HasSubstr("Segmentation: no *.txt with names of pictures"));
  fs::remove_all(tree_ / "ImageSets");
  EXPECT_THAT(Refusal(), HasSubstr("Segmentation: cannot read the folder"));
  fs::remove(tree_ / "labelmap.txt");
  EXPECT_THAT(Refusal(), HasSubstr("neither labelmap.txt (\"Segmentation mask 1.1\") nor annot"));
}

TEST_F(ListCvatTest, TellsTheExportsApart) {
  WriteText("annotations.xml", "<annotations/>");
  EXPECT_THAT(Refusal(), HasSubstr("both labelmap.txt"));
  EXPECT_THROWS_MESSAGE(ListCvat(tree_ / "annotations.xml", {}),
                        Error,
                        HasSubstr("annotations.xml:1: <annotations>: no <image>"));
  fs::remove(tree_ / "labelmap.txt");
  EXPECT_THAT(Refusal(), HasSubstr("annotations.xml:1: <annotations>: no <image>"));
}

TEST_F(ListCvatTest, NamesTheLineOfALabelMap) {
  for (const std::string line : {"handle",
                                 "handle:",
                                 "handle:1,2::",
                                 "handle:1,2,256::",
                                 "handle:1,2,3,4::",
                                 "handle:-1,2,3::",
                                 "handle:red::",
                                 ":1,2,3::"}) {
    WriteText("labelmap.txt", "blur:9,8,7::\n" + line + "\n");
    EXPECT_THAT(Refusal(), HasSubstr("labelmap.txt:2: '" + line + "' where label:red,green,blue"));
  }
  WriteText("labelmap.txt", "blur:9,8,7::\nhandle:9,8,7::\n");
  EXPECT_THAT(Refusal(), HasSubstr(":2: 'handle:9,8,7::' has the colour of 'blur'"));
}

TEST_F(ListCvatTest, RefusesMasksThatDoNotFit) {
  WriteMask("a", {{0, 0, 0}, {83, 50, 250}, {3, 2, 1}});
  EXPECT_THAT(Refusal(), HasSubstr("a.png: the colour 1,2,3 at column 2, row 0 is of no label"));
  WriteMask("a", {{0, 0, 0}, {83, 50, 250}});
  EXPECT_THAT(Refusal(), HasSubstr("a.png: the mask is 2x1 pixels, its picture 3x1"));
  testing::WriteTurnedJpeg(tree_ / "SegmentationClass/a.png", 8, 6);
  EXPECT_THAT(Refusal(), HasSubstr("labels in a JPEG"));
  WriteText("SegmentationClass/a.png", "");
  EXPECT_THAT(Refusal(), HasSubstr("SegmentationClass/a.png"));
}

}  // namespace
}  // namespace handcraft::datasets
