// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/cvat_shapes.h"

#include <string>
#include <utility>
#include <vector>

#include "lib/core/rng.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* kMeta =
    "<?xml version=\"1.0\" "
    "encoding=\"utf-8\"?>\n<annotations>\n<version>1.1</version>\n<meta><task>"
    "<labels><label><name>good</name></label><label><name>table</name></label></labels>"
    "</task></meta>\n";

// Pictures of 6 × 4.
class ListCvatShapesTest : public ImporterTest {
 protected:
  void SetUp() override { WriteImage("images/a.png", 6, 4); }

  [[nodiscard]] SourceSet List(const std::string& images, const CvatOptions& options = {}) const {
    WriteText("annotations.xml", kMeta + images + "\n</annotations>\n");
    return ListCvatShapes(tree_ / "annotations.xml", options);
  }
  [[nodiscard]] static std::string ImageOf(const std::string& shapes) {
    return "<image id=\"0\" name=\"a.png\" width=\"6\" height=\"4\">\n" + shapes + "</image>";
  }
  [[nodiscard]] std::string Refusal(const std::string& images,
                                    const CvatOptions& options = {}) const {
    return RefusalOf([&] { return List(images, options); });
  }
  // Row by row, one letter a pixel: G good, . bad, - don't care.
  [[nodiscard]] std::string MaskOf(const std::string& shapes,
                                   const CvatOptions& options = {}) const {
    const Image mask = List(ImageOf(shapes), options).pictures.at(0).make_mask(6, 4);
    std::string letters;
    for (const std::uint8_t value : mask.values()) {
      letters += value == kMaskGood ? 'G' : value == kMaskBad ? '.' : '-';
    }
    return letters;
  }
};

TEST_F(ListCvatShapesTest, ReadsEachTypeOfShape) {
  EXPECT_EQ(MaskOf("<polygon label=\"good\" source=\"manual\" occluded=\"0\" "
                   "points=\"1.00,0.00;3.00,0.00;3.00,2.00;1.00,2.00\" z_order=\"0\"/>"),
            ".GG..."
            ".GG..."
            "......"
            "......");
  EXPECT_EQ(MaskOf("<box label=\"good\" xtl=\"4.0\" ytl=\"1\" xbr=\"6\" ybr=\"4\"/>"),
            "......"
            "....GG"
            "....GG"
            "....GG");
  // The example of the documentation's rule: along the rows of the box, outside first.
  EXPECT_EQ(MaskOf("<mask label=\"good\" rle=\"1, 4, 1\" left=\"2\" top=\"1\" width=\"3\" "
                   "height=\"2\"/>"),
            "......"
            "...GG."
            "..GG.."
            "......");
  EXPECT_EQ(MaskOf("<mask label=\"good\" rle=\"0,24\" left=\"0\" top=\"0\" width=\"6\" "
                   "height=\"4\"/>"),
            std::string(24, 'G'));
}

TEST_F(ListCvatShapesTest, TurnsABoxClockwise) {
  const std::string box = "<box label=\"good\" xtl=\"1\" ytl=\"1\" xbr=\"5\" ybr=\"3\" rotation=";
  EXPECT_EQ(MaskOf(box + "\"90.00\"/>"),
            "..GG.."
            "..GG.."
            "..GG.."
            "..GG..");
  // The right end goes down: the middle of column 4, row 2 is inside, that of row 1 no longer.
  const std::string turned = MaskOf(box + "\"30\"/>");
  EXPECT_EQ(turned.substr(6, 6), ".GGG..");
  EXPECT_EQ(turned.substr(12, 6), "..GGG.");
}

TEST_F(ListCvatShapesTest, GivesLabelsTheirRoles) {
  const std::string whole = "<box label=\"table\" xtl=\"0\" ytl=\"0\" xbr=\"6\" ybr=\"4\"/>";
  const std::string column = "<box label=\"good\" xtl=\"0\" ytl=\"0\" xbr=\"1\" ybr=\"4\"/>";
  EXPECT_EQ(MaskOf(column + whole), "G.....G.....G.....G.....") << "without a role";
  EXPECT_EQ(MaskOf(whole + column, {.roles = {.dont_care = {"table"}}}), std::string(24, '-'));
  EXPECT_EQ(MaskOf("<polyline label=\"table\" points=\"0,0;1,1\"/><tag label=\"good\"/>"),
            std::string(24, '.'));
  EXPECT_THAT(Refusal(ImageOf(""), {.roles = {.good = {"handle"}}}),
              HasSubstr("nothing is labelled 'handle'; there are: 'good', 'table'"));
}

TEST_F(ListCvatShapesTest, FindsPictures) {
  WriteImage("images/mug/b ü &.png", 6, 4);
  WriteImage("images/Train/c.png", 6, 4);
  const std::string size = "\" width=\"6\" height=\"4\"";
  const SourceSet source =
      List(ImageOf("") + "<image name=\"mug/b ü &amp;.png" + size + " subset=\"Train\"/>" +
           "<image name=\"c.png" + size + " subset=\"Train\"/>");
  ASSERT_THAT(source.pictures, SizeIs(3));
  EXPECT_EQ(source.pictures[1].image, "mug/b ü &.png");
  EXPECT_EQ(source.pictures[1].mask, "mug/b ü &.png");
  EXPECT_EQ(source.pictures[1].object_class, "mug");
  EXPECT_EQ(source.pictures[1].instance, "mug/b ü &");
  EXPECT_EQ(source.pictures[2].image, "Train/c.png");
  ImportPictures(source, out_, {});
  EXPECT_THAT(ReadLabelledImageSet(out_).items, SizeIs(3));
  fs::rename(tree_ / "images", tree_ / "photos");
  EXPECT_THAT(Refusal(ImageOf("")), HasSubstr("none of its pictures is below "));
  EXPECT_THAT(List(ImageOf(""), {.images = tree_ / "photos"}).pictures, SizeIs(1));
}

// Oracle: runs are written out pixel by pixel.
TEST_F(ListCvatShapesTest, AgreesWithRunsWrittenOut) {
  Rng rng(5);
  for (int round = 0; round < 20; ++round) {
    std::string expected(24, '.');
    std::string runs;
    for (std::size_t at = 0, turn = 0; at < 8; ++turn) {  // the box holds columns 1 … 4, rows 1, 2
      const std::size_t length = std::min<std::size_t>(rng.UniformInt(5), 8 - at);
      runs += (turn > 0 ? ", " : "") + std::to_string(length);
      for (std::size_t end = at + length; at < end; ++at) {
        if (turn % 2 == 1) expected[(1 + at / 4) * 6 + 1 + at % 4] = 'G';
      }
    }
    EXPECT_EQ(MaskOf("<mask label=\"good\" rle=\"" + runs +
                     "\" left=\"1\" top=\"1\" width=\"4\" height=\"2\"/>"),
              expected)
        << runs;
  }
}

TEST_F(ListCvatShapesTest, NamesTheLineOfAFault) {
  const auto polygon = [](const std::string& points) {
    return ImageOf("<polygon label=\"good\" points=\"" + points + "\"/>");
  };
  const auto mask = [](const std::string& rle, const std::string& box) {
    return ImageOf("<mask label=\"good\" rle=\"" + rle + "\" " + box + "/>");
  };
  const std::string box = "left=\"0\" top=\"0\" width=\"2\" height=\"2\"";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {polygon("1,2;3,4"), "annotations.xml:6: <polygon>: a polygon has three corners"},
      {polygon("1,2;3,4;5"), "points are not as"},
      {polygon("1,2,3,4,5,6"), "points are not as"},
      {polygon("1,2;3,4;nan,1"), "a corner beyond any picture"},
      {polygon("1,2;3,4;1e7,1"), "a corner beyond any picture"},
      {polygon("1,2;3,4;5,6;"), "points are not as"},
      {mask("4", "left=\"0\" top=\"0\" width=\"7\" height=\"2\""), "width is '7'; a whole number"},
      {mask("4", "left=\"5\" top=\"0\" width=\"2\" height=\"2\""), "width is '2'; a whole number"},
      {mask("4", "left=\"-1\" top=\"0\" width=\"2\" height=\"2\""), "left is '-1'"},
      {mask("3", box), "the runs are 3 pixels, the mask has 4"},
      {mask("", box), "the runs are 0 pixels"},
      {mask("1,4", box), "the runs are longer than the mask"},
      {mask("4294967295,5", box), "the runs are longer"},
      {mask("1,-1,4", box), "rle is not numbers"},
      {mask("1;3", box), "rle is not numbers"},
      {ImageOf("<box label=\"good\" xtl=\"0\"/>"), "no attribute 'ytl'"},
      {ImageOf("<box xtl=\"0\"/>"), "no attribute 'label'"},
      {ImageOf("<ellipse label=\"good\"/>"), "a shape of type 'ellipse'; polygon, box or mask"},
      {"<image name=\"../tree/images/a.png\" width=\"6\" height=\"4\"/>", "leads out of"},
      {"<image name=\"a.png\" width=\"0\" height=\"4\"/>", "width is '0'"},
      {"<image name=\"a.png\" width=\"5\" height=\"4\"/>",
       "picture is 5x4 pixels, its picture 6x4"},
      {"<image name=\"a.png\"/>", "annotations.xml:5: <image>: no attribute 'width'"},
      {"<track id=\"0\"/>", "tracks of a video (export as \"CVAT for images 1.1\")"},
      {"", "no <image> in it"},
      {ImageOf("") + ImageOf(""), "stands for the same picture as"}};
  for (const auto& [images, message] : cases) EXPECT_THAT(Refusal(images), HasSubstr(message));
}

TEST_F(ListCvatShapesTest, RefusesAnotherFile) {
  WriteText("annotations.xml", "<html></html>");
  EXPECT_THROWS_MESSAGE(ListCvatShapes(tree_ / "annotations.xml", {}),
                        Error,
                        HasSubstr("<html>: the file of CVAT begins with <annotations>"));
  WriteText("annotations.xml", std::string(kMeta) + ImageOf(""));
  EXPECT_THROWS_MESSAGE(
      ListCvatShapes(tree_ / "annotations.xml", {}), Error, HasSubstr("this is not XML"));
}

TEST_F(ListCvatShapesTest, RefusesAShapeOutsideItsPicture) {
  EXPECT_THROWS_MESSAGE(
      MaskOf("<box label=\"good\" xtl=\"-9\" ytl=\"1\" xbr=\"-3\" ybr=\"4\"/>"),
      Error,
      HasSubstr("annotations.xml: line 6, <box>: the shape lies outside its picture of 6x4"));
}

}  // namespace
}  // namespace handcraft::datasets
