// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/coco.h"

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::SizeIs;

// Two pictures of 6 × 4: on the first the columns 1 and 2 are good, as a polygon.
json Annotations() {
  return json::parse(R"({
    "info": {"year": 2017},
    "images": [
      {"id": 7, "file_name": "a.png", "width": 6, "height": 4, "license": 1},
      {"id": 9, "file_name": "mug/b.png", "width": 6, "height": 4}],
    "categories": [{"id": 1, "name": "good", "supercategory": "x"}, {"id": 90, "name": "blade"}],
    "annotations": [
      {"id": 1, "image_id": 7, "category_id": 1, "iscrowd": 0, "bbox": [1, 0, 2, 4],
       "segmentation": [[1, 0, 2, 0, 2, 4, 1, 4], [2, 0, 3, 0, 3, 4, 2, 4]]}]})");
}

// One annotation for the second picture.
json Annotation(const json& segmentation, int category = 1, int is_crowd = 0) {
  return {{"id", 2},
          {"image_id", 9},
          {"category_id", category},
          {"iscrowd", is_crowd},
          {"segmentation", segmentation}};
}

class ListCocoTest : public ImporterTest {
 protected:
  void SetUp() override {
    WriteImage("a.png", 6, 4);
    WriteImage("mug/b.png", 6, 4);
  }
  [[nodiscard]] SourceSet List(const json& annotations, const CocoOptions& options = {}) const {
    WriteFileAtomically(file_, annotations.dump());
    return ListCoco(file_, options);
  }
  [[nodiscard]] std::string Refusal(const json& annotations,
                                    const CocoOptions& options = {}) const {
    return RefusalOf([&] { return List(annotations, options); });
  }
  // Row by row, one letter a pixel: G good, . bad, - don't care.
  [[nodiscard]] std::string MaskOfSecond(const json& annotation,
                                         const CocoOptions& options = {}) const {
    json annotations = Annotations();
    annotations["annotations"].push_back(annotation);
    const Image mask = List(annotations, options).pictures.at(1).make_mask(6, 4);
    std::string letters;
    for (const std::uint8_t value : mask.values()) {
      letters += value == kMaskGood ? 'G' : value == kMaskBad ? '.' : '-';
    }
    return letters;
  }

  fs::path file_ = tree_ / "instances.json";
};

TEST_F(ListCocoTest, ReadsPolygons) {
  const LabelledImageSet set = ImportPictures(List(Annotations()), out_, {});
  ASSERT_THAT(set.items, SizeIs(2));
  EXPECT_EQ(set.items[1].image, "images/mug/b.png");
  EXPECT_EQ(set.items[1].mask, "masks/mug/b.png");
  EXPECT_EQ(set.items[1].object_class, "mug");
  EXPECT_EQ(set.items[1].instance, "mug/b");
  const Image mask = ReadMask(set, 0);
  EXPECT_EQ(mask.At(0, 3), kMaskBad);
  EXPECT_EQ(mask.At(1, 0), kMaskGood);
  EXPECT_EQ(mask.At(2, 3), kMaskGood);
  EXPECT_EQ(mask.At(3, 3), kMaskBad);
  EXPECT_EQ(ReadMask(set, 1).values(), std::vector<std::uint8_t>(24, kMaskBad)) << "not annotated";
}

TEST_F(ListCocoTest, ReadsRunsWrittenOutAndCompressed) {
  // Down the columns 5 outside, 6 inside, 13 outside.
  const std::string expected =
      "..G..."
      ".GG..."
      ".GG..."
      ".G....";
  EXPECT_EQ(MaskOfSecond(Annotation({{"size", {4, 6}}, {"counts", {5, 6, 13}}})), expected);
  EXPECT_EQ(MaskOfSecond(Annotation({{"size", {4, 6}}, {"counts", "56="}})), expected);
}

TEST_F(ListCocoTest, TakesCrowdsForDontCare) {
  const json whole = {{"size", {4, 6}}, {"counts", {0, 24}}};
  EXPECT_EQ(MaskOfSecond(Annotation(whole, 1, 1)), std::string(24, '-'));
  EXPECT_EQ(MaskOfSecond(Annotation(whole, 90, 1)), std::string(24, '.')) << "without a role";
  EXPECT_EQ(MaskOfSecond(Annotation(whole, 90), {.roles = {.dont_care = {"blade"}}}),
            std::string(24, '-'));
  EXPECT_EQ(MaskOfSecond(Annotation(whole, 90), {.roles = {.good = {"blade", "good"}}}),
            std::string(24, 'G'));
}

TEST_F(ListCocoTest, FindsPicturesInAnotherFolder) {
  fs::rename(tree_ / "mug/b.png", tree_ / "mug/a.png");
  json annotations = Annotations();
  annotations["images"].erase(1);
  const SourceSet source = List(annotations, {.images = tree_ / "mug"});
  EXPECT_EQ(source.pictures.at(0).path, tree_ / "mug/a.png");
  EXPECT_THAT(Refusal(annotations, {.images = folder_ / "no"}),
              HasSubstr("none of its pictures is below " + (folder_ / "no").string()));
}

TEST_F(ListCocoTest, NamesThePlaceOfAFault) {
  const auto refusal_of = [&](const char* pointer, const json& value) {
    json annotations = Annotations();
    annotations[json::json_pointer(pointer)] = value;
    return Refusal(annotations);
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {refusal_of("/images", json::array()), "instances.json: at /images: no image is listed"},
      {refusal_of("/images", 3), "at /images: 3; a list is due"},
      {refusal_of("/images/1/id", 7), "at /images/1/id: another image has this id"},
      {refusal_of("/images/1/id", "nine"), "at /images/1/id: \"nine\"; a number is due"},
      {refusal_of("/images/0/width", 0), "at /images/0/width: 0; a whole number from 1"},
      {refusal_of("/images/0/width", 5), "the labelled picture is 5x4 pixels, its picture 6x4"},
      {refusal_of("/images/1/file_name", "a.png"), "stands for the same picture as"},
      {refusal_of("/images/1/file_name", "../tree/a.png"), "leads out of"},
      {refusal_of("/images/1/file_name", "/etc/passwd"), "leads out of"},
      {refusal_of("/categories/1/id", 1), "at /categories/1/id: another category"},
      {refusal_of("/annotations/0/category_id", 2), "no category has this id"},
      {refusal_of("/annotations/0/image_id", 8), "no image has this id"},
      {refusal_of("/annotations/0/iscrowd", 2), "at /annotations/0/iscrowd: 2; a whole number"},
      {refusal_of("/annotations/0/segmentation", json::array()), "without an outline"},
      {refusal_of("/annotations/0/segmentation", "x"), "\"x\"; an object is due"},
      {refusal_of("/annotations/0/segmentation/0", {1, 2, 3, 4}), "4 numbers; a polygon has"},
      {refusal_of("/annotations/0/segmentation/0", {1, 2, 3, 4, 5, 6, 7}), "7 numbers; a polygon"},
      {refusal_of("/annotations/0/segmentation/0/2", 1e7), "a corner beyond any picture"}};
  for (const auto& [refusal, message] : cases) EXPECT_THAT(refusal, HasSubstr(message));
  json annotations = Annotations();
  annotations["annotations"][0].erase("segmentation");
  EXPECT_THAT(Refusal(annotations), HasSubstr("at /annotations/0: no member 'segmentation'"));
  annotations.erase("categories");
  EXPECT_THAT(Refusal(annotations), HasSubstr("instances.json: no member 'categories'"));
}

TEST_F(ListCocoTest, RefusesRunsThatDoNotFit) {
  const auto refusal_of = [&](const json& size, const json& counts) {
    json annotations = Annotations();
    annotations["annotations"].push_back(Annotation({{"size", size}, {"counts", counts}}));
    return Refusal(annotations);
  };
  EXPECT_THAT(refusal_of({6, 4}, {24}),
              HasSubstr("/size: not the size of the picture: 4 rows of 6"));
  EXPECT_THAT(refusal_of({4, 6}, {23}), HasSubstr("the runs are 23 pixels, the picture has 24"));
  EXPECT_THAT(refusal_of({4, 6}, {4294967295U, 4294967295U, 26}),
              HasSubstr("the runs are 8589934616"));
  EXPECT_THAT(refusal_of({4, 6}, {25, -1}), HasSubstr("/counts/1: -1; a whole number from 0"));
  EXPECT_THAT(refusal_of({4, 6}, {1e300}), HasSubstr("/counts/0: 1e+300; a whole number"));
  EXPECT_THAT(refusal_of({4, 6}, "P"), HasSubstr("/counts: not a text of compressed runs"));
  EXPECT_THAT(refusal_of({4, 6}, json::array()), HasSubstr("the runs are 0 pixels"));
}

TEST_F(ListCocoTest, RefusesRolesThatNoCategoryHas) {
  EXPECT_THAT(Refusal(Annotations(), {.roles = {.good = {"handle"}}}),
              HasSubstr("nothing is labelled 'handle'; there are: 'blade', 'good'"));
}

TEST_F(ListCocoTest, RefusesAFolder) {
  EXPECT_THROWS_MESSAGE(ListCoco(file_.parent_path(), {}),
                        Error,
                        HasSubstr("is a folder (name the JSON file of the annotations"));
}

TEST_F(ListCocoTest, RefusesATruncatedFile) {
  const std::string text = Annotations().dump();
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, text.size() / 2, text.size() - 1}) {
    WriteFileAtomically(file_, text.substr(0, size));
    EXPECT_THROWS_MESSAGE(ListCoco(file_, {}), Error, HasSubstr("JSON"));
  }
}

TEST_F(ListCocoTest, RefusesAPolygonOutsideItsPicture) {
  const json polygons = {{0, 0, 2, 0, 2, 2}, {0, 9, 3, 9, 3, 12}};
  EXPECT_THROWS_MESSAGE(MaskOfSecond(Annotation(polygons)),
                        Error,
                        HasSubstr("instances.json: at /annotations/1/segmentation/1: the shape "
                                  "lies outside its picture of 6x4 pixels"));
}

}  // namespace
}  // namespace handcraft::datasets
