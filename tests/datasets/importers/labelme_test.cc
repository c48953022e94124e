// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/labelme.h"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/datasets/importers/importer_test.h"
#include "tests/support/turned_jpeg.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A file as LabelMe writes it, for a picture of 6 × 4 with one good column.
json Annotation(const std::string& image) {
  return {{"version", "5.4.1"},
          {"flags", json::object()},
          {"shapes",
           {{{"label", "good"},
             {"points", {{1, 0}, {2, 4}}},
             {"group_id", nullptr},
             {"shape_type", "rectangle"},
             {"flags", json::object()}}}},
          {"imagePath", image},
          {"imageData", nullptr},
          {"imageHeight", 4},
          {"imageWidth", 6}};
}

std::string Base64(const std::vector<std::uint8_t>& bytes) {
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return k < bytes.size() ? bytes[k] : 0U; };
    const unsigned bits = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += alphabet[bits >> shift & 63];
  }
  const std::size_t num_padding = (3 - bytes.size() % 3) % 3;
  text.resize(text.size() - num_padding);
  return text + std::string(num_padding, '=');
}

class ListLabelmeTest : public ImporterTest {
 protected:
  void SetUp() override { fs::create_directory(tree_); }

  void Write(const std::string& name, const json& annotation) const {
    WriteText(name, annotation.dump());
  }
  // The refusal of the picture a.png with this annotation.
  [[nodiscard]] std::string Refusal(const json& annotation, const LabelRoles& roles = {}) const {
    Write("a.json", annotation);
    WriteImage("a.png", 6, 4);
    return RefusalOf([&] { return ListLabelme(tree_, roles); });
  }
};

TEST_F(ListLabelmeTest, ReadsPicturesBesideTheFiles) {
  WriteImage("cup ü, \"1\"\n.png", 6, 4);
  WriteImage("mug/deep/b.png", 6, 4);
  Write("a.json", Annotation("cup ü, \"1\"\n.png"));
  Write("mug/b.json", Annotation("deep\\b.png"));  // as Windows writes it
  const SourceSet source = ListLabelme(tree_, {});
  ASSERT_THAT(source.pictures, SizeIs(2));
  EXPECT_EQ(source.pictures[1].image, "mug/deep/b.png");
  EXPECT_EQ(source.pictures[1].mask, "mug/deep/b.png");
  EXPECT_EQ(source.pictures[1].object_class, "mug");
  EXPECT_EQ(source.pictures[1].instance, "mug/deep/b");
  const LabelledImageSet set = ImportPictures(source, out_, {});
  EXPECT_THAT(FindFaults(ReadLabelledImageSet(out_)), IsEmpty());
  const Image mask = ReadMask(set, 0);
  EXPECT_EQ(mask.At(0, 2), kMaskBad);
  EXPECT_EQ(mask.At(1, 2), kMaskGood);
  EXPECT_EQ(mask.At(2, 2), kMaskBad);
}

TEST_F(ListLabelmeTest, TakesAnEmbeddedPictureAsItIs) {
  WriteImage("other.png", 6, 4);
  const std::vector<std::uint8_t> bytes = ReadFile(tree_ / "other.png");
  fs::remove(tree_ / "other.png");
  json annotation = Annotation("../elsewhere/cup.jpg");  // not read
  annotation["imageData"] = Base64(bytes);
  Write("cup.json", annotation);
  const LabelledImageSet set = ImportPictures(ListLabelme(tree_, {}), out_, {});
  EXPECT_EQ(set.items.at(0).image, "images/cup.png");
  EXPECT_EQ(ReadFile(folder_ / "out/images/cup.png"), bytes);
}

TEST_F(ListLabelmeTest, DrawsEachTypeOfShape) {
  json annotation = Annotation("a.png");
  annotation["shapes"] = {
      {{"label", "rim"}, {"points", {{0, 0}, {3, 0}, {3, 1}, {0, 1}}}},  // polygon if not said
      {{"label", "blur"}, {"points", {{5.5, 3.5}, {5.5, 2.7}}}, {"shape_type", "circle"}},
      {{"label", "burr"}, {"points", {{2, 1}, {0.2, 0}}}, {"shape_type", "rectangle"}},
      {{"label", "note"}, {"points", {{2, 1}}}, {"shape_type", "point"}}};
  Write("a.json", annotation);
  WriteImage("a.png", 6, 4);
  const SourceSet source =
      ListLabelme(tree_, {.good = {"rim"}, .bad = {"burr"}, .dont_care = {"blur"}});
  const Image mask = source.pictures.at(0).make_mask(6, 4);
  EXPECT_EQ(mask.At(0, 0), kMaskBad) << "burr";
  EXPECT_EQ(mask.At(2, 0), kMaskGood);
  EXPECT_EQ(mask.At(3, 0), kMaskBad);
  EXPECT_EQ(mask.At(5, 3), kMaskDontCare);
  EXPECT_EQ(mask.At(4, 3), kMaskBad);
}

TEST_F(ListLabelmeTest, NamesThePlaceOfAFault) {
  const auto refusal_of = [&](const char* pointer, const json& value) {
    json annotation = Annotation("a.png");
    annotation[json::json_pointer(pointer)] = value;
    return Refusal(annotation);
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {refusal_of("/shapes", "x"), "a.json: at /shapes: \"x\"; a list is due"},
      {refusal_of("/shapes/0", 1), "at /shapes/0: 1; an object is due"},
      {refusal_of("/shapes/0/label", 7), "at /shapes/0/label: 7; a text is due"},
      {refusal_of("/shapes/0/points/1/0", "2"), "at /shapes/0/points/1/0: \"2\"; a number"},
      {refusal_of("/shapes/0/points/1", {1, 2, 3}), "/points/1: a point has two numbers"},
      {refusal_of("/shapes/0/points/1/0", 1e300), "a point beyond any picture"},
      {refusal_of("/shapes/0/points", json::array()), "a rectangle has two points"},
      {refusal_of("/shapes/0/shape_type", "polygon"), "a polygon has three points or more"},
      {refusal_of("/shapes/0/shape_type", "linestrip"),
       "'linestrip'; polygon, rectangle or circle"},
      {refusal_of("/imageHeight", -1), "at /imageHeight: -1; a whole number"},
      {refusal_of("/imageHeight", 5), "the labelled picture is 6x5 pixels, its picture 6x4"},
      {refusal_of("/imagePath", nullptr), "at /imagePath: null; a text is due"},
      {refusal_of("/imagePath", "no.png"),
       "a.json: left out: the picture that it names is not there"},
      {refusal_of("/imageData", "?"), "at /imageData: the embedded picture is not base64"},
      {refusal_of("/imageData", "Zm9v"), "is not PNG, JPEG, BMP, PGM or PPM"},
      {refusal_of("/imageData", "iVBORw=="), "the embedded picture: "}};
  for (const auto& [refusal, message] : cases) EXPECT_THAT(refusal, HasSubstr(message));
}

TEST_F(ListLabelmeTest, RefusesNamesThatLeadOut) {
  WriteFileAtomically(folder_ / "secret.png", "");
  for (const char* name :
       {"../secret.png", "/etc/passwd", "x/../../secret.png", "..\\secret.png"}) {
    EXPECT_THAT(Refusal(Annotation(name)), HasSubstr("leads out of")) << name;
  }
}

TEST_F(ListLabelmeTest, RefusesAWrongTree) {
  EXPECT_THROWS_MESSAGE(ListLabelme(tree_, {}),
                        Error,
                        HasSubstr("no LabelMe file *.json with its picture; found 0 files"));
  EXPECT_THAT(Refusal({{"images", json::array()}}), HasSubstr("a.json: no member 'shapes'"));
  EXPECT_THAT(Refusal(Annotation("a.png"), {.good = {"handle"}}),
              HasSubstr("nothing is labelled 'handle'; there are: 'good'"));
  EXPECT_THAT(Refusal(Annotation("a.png"), {.good = {"good"}, .bad = {"good"}}),
              HasSubstr("the label 'good' has two roles"));
  WriteText("a.json", Annotation("a.png").dump().substr(0, 100));
  EXPECT_THROWS_MESSAGE(
      ListLabelme(tree_, {}), Error, HasSubstr("a.json at byte 100: this is not JSON"));
  WriteText("a.json", "");
  EXPECT_THROWS_MESSAGE(ListLabelme(tree_, {}), Error, HasSubstr("the file is empty"));
}

TEST_F(ListLabelmeTest, RefusesTwoFilesOfOnePicture) {
  Write("b.json", Annotation("a.png"));
  EXPECT_THAT(Refusal(Annotation("a.png")), HasSubstr("stands for the same picture as"));
}

// Adversaries: pictures a camera or a tool may hand over.
TEST_F(ListLabelmeTest, TakesATurnedJpegAndRefusesSixteenBit) {
  json annotation = Annotation("a.jpg");
  annotation["imageWidth"] = 48;
  annotation["imageHeight"] = 64;
  Write("a.json", annotation);
  testing::WriteTurnedJpeg(tree_ / "a.jpg", 64, 48);
  EXPECT_EQ(ReadMask(ImportPictures(ListLabelme(tree_, {}), folder_ / "a", {}), 0).height(), 64);
  std::swap(annotation["imageWidth"], annotation["imageHeight"]);
  Write("a.json", annotation);
  EXPECT_THROWS_MESSAGE(ImportPictures(ListLabelme(tree_, {}), folder_ / "b", {}),
                        Error,
                        HasSubstr("is 64x48 pixels, its picture 48x64"));
  Write("a.json", Annotation("deep.png"));
  cv::imwrite((tree_ / "deep.png").string(), cv::Mat(4, 6, CV_16UC1, cv::Scalar(1)));
  EXPECT_THROWS_MESSAGE(ImportPictures(ListLabelme(tree_, {}), folder_ / "c", {}),
                        Error,
                        AllOf(HasSubstr("deep.png"), HasSubstr("16")));
}

TEST_F(ListLabelmeTest, RefusesAShapeOutsideItsPicture) {
  json annotation = Annotation("a.png");
  annotation["shapes"].push_back(annotation["shapes"][0]);
  annotation["shapes"][1]["points"] = {{30, 10}, {40, 20}};
  Write("a.json", annotation);
  WriteImage("a.png", 6, 4);
  EXPECT_THROWS_MESSAGE(
      ImportPictures(ListLabelme(tree_, {}), out_, {}),
      Error,
      HasSubstr("a.json: at /shapes/1: the shape lies outside its picture of 6x4 pixels"));
  EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace handcraft::datasets
