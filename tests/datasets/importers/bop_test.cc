// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "datasets/importers/bop.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "datasets/importers/view_set_import.h"
#include "datasets/view_set_faults.h"
#include "lib/core/rng.h"
#include "tests/datasets/importers/importer_test.h"

namespace handcraft::datasets {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Looks along the camera's axis at a model that stands upright half a metre away, its x axis turned
// by so much from the camera's forward direction.
json Upright(double turn_deg, int object) {
  const double turn = turn_deg * std::numbers::pi / 180;
  Eigen::Matrix3d camera_from_base;  // columns: forward, left, up
  camera_from_base << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  const Eigen::Matrix3d R =
      camera_from_base * Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  json rows = json::array();
  for (int i = 0; i < 9; ++i) rows.push_back(R(i / 3, i % 3));
  return {{"cam_R_m2c", rows}, {"cam_t_m2c", {0, 0, 500}}, {"obj_id", object}};
}

// A scene of two pictures of 12 × 8; the first shows two objects, two pixels each.
class ListBopTest : public ImporterTest {
 protected:
  void SetUp() override {
    const json camera = {{"cam_K", {100, 0, 5, 0, 100, 4, 0, 0, 1}}, {"depth_scale", 0.5}};
    cameras_ = {{"0", camera}, {"10", camera}};
    objects_ = {{"0", {Upright(30, 1), Upright(300, 5)}}, {"10", {Upright(0, 1)}}};
    WriteImage("1/rgb/000000.png", 12, 8);
    WriteImage("1/gray/000010.jpg", 12, 8);
    AddMask("000000_000000", 5, 4);
    AddMask("000000_000001", 10, 0);
    AddMask("000010_000000", 2, 2);
    fs::create_directories(tree_ / "1/depth");
    perception::WritePng16(tree_ / "1/depth/000000.png", BasicImage<std::uint16_t>(12, 8, 1, 1000));
    WriteFiles();
  }
  void AddMask(const std::string& name, int u, int v) const {
    Image mask(12, 8);
    mask.At(u, v) = mask.At(u + 1, v) = 255;
    WriteImage("1/mask_visib/" + name + ".png", mask);
  }
  void WriteFiles() const {
    WriteText("1/scene_camera.json", cameras_.dump());
    WriteText("1/scene_gt.json", objects_.dump());
  }
  [[nodiscard]] SourceSet List(const BopOptions& options = {.margin_px = 1}) const {
    return ListBop(tree_, options);
  }
  [[nodiscard]] std::string Refusal(const BopOptions& options = {}) const {
    try {
      ImportViews(List(options), out_, {});
    } catch (const Error& error) {
      return error.what();
    }
    return "(nothing was thrown)";
  }

  json cameras_, objects_;
};

TEST_F(ListBopTest, CutsAViewOutForEachObject) {
  const SourceSet source = List();
  ASSERT_THAT(source.pictures, SizeIs(3));
  EXPECT_EQ(source.pictures[0].image, "1/000000_000000.png");
  EXPECT_EQ(source.pictures[0].instance, "obj_000001");
  EXPECT_EQ(source.pictures[1].object_class, "obj_000005");
  EXPECT_NEAR(*source.pictures[0].angle_deg, 30, 1e-6);
  EXPECT_NEAR(*source.pictures[1].angle_deg, 300, 1e-6);
  EXPECT_FALSE(source.pictures[2].make_cloud) << "no depth";
  ImportViews(source, out_, {});
  const ViewSet set = ReadViewSet(out_);
  EXPECT_THAT(FindFaults(set), IsEmpty());
  const LoadedView view = ReadView(set, 0);
  EXPECT_EQ(view.image.width(), 4);  // two pixels and the margin
  EXPECT_EQ(view.image.height(), 3);
  EXPECT_EQ(view.object_mask.values(),
            (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 255, 255, 0, 0, 0, 0, 0}));
  const Image whole = perception::ReadImage(tree_ / "1/rgb/000000.png");
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_EQ(view.image.At(0, 0, channel), whole.At(4, 3, channel));
  }
  EXPECT_EQ(ReadView(set, 1).image.width(), 3) << "the picture ends there";
}

// The pixel (5, 4) is on the axis; 1000 half millimetres are where the model's origin is.
TEST_F(ListBopTest, PutsCloudsIntoTheFrameOfTheModel) {
  const OrganisedCloud cloud = List().pictures[0].make_cloud(4, 3);
  EXPECT_LT(cloud.At(1, 1).norm(), 1e-6F);
  EXPECT_TRUE(cloud.At(2, 1).isApprox(Eigen::Vector3f(0, -0.005F, 0), 1e-4F)) << "to the right";
  EXPECT_TRUE(cloud.At(1, 2).isApprox(Eigen::Vector3f(0, 0, -0.005F), 1e-4F)) << "down";
  EXPECT_TRUE(cloud.base_from_camera.translation().isApprox(Eigen::Vector3f(-0.5F, 0, 0), 1e-5F));
}

// Law: a model's own points keep their place but for the turn, wherever the camera stands.
TEST_F(ListBopTest, TurnsTheModelByTheAngle) {
  Rng rng(3);
  for (int round = 0; round < 20; ++round) {
    Eigen::Vector4d q(rng.Normal(), rng.Normal(), rng.Normal(), rng.Normal());
    const Eigen::Matrix3d R = Eigen::Quaterniond(q.normalized()).toRotationMatrix();
    const Eigen::Vector3d t(rng.Normal(), rng.Normal(), rng.Normal());
    json rows = json::array();
    for (int i = 0; i < 9; ++i) rows.push_back(R(i / 3, i % 3));
    objects_["0"][0]["cam_R_m2c"] = rows;
    objects_["0"][0]["cam_t_m2c"] = {1000 * t.x(), 1000 * t.y(), 1000 * t.z()};
    WriteFiles();
    const SourcePicture view = List().pictures.at(0);
    const Eigen::Isometry3f pose = view.make_cloud(4, 3).base_from_camera;
    const Eigen::Vector3d p(0.1, 0.2, 0.3);
    const Eigen::Vector3f p_in_base = pose * (R * p + t).cast<float>();
    const double turn = view.angle_deg.value_or(0) * std::numbers::pi / 180;
    const Eigen::Vector3d expected = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * p;
    EXPECT_LT((p_in_base - expected.cast<float>()).norm(), 1e-5F);
    if (!view.angle_deg) continue;
    EXPECT_LE(pose.translation().x(), 0.0F) << "the camera stands on the side of -x";
    EXPECT_NEAR(pose.translation().y(), 0.0F, 1e-5F);
  }
}

TEST_F(ListBopTest, KnowsNoAngleSeenFromAbove) {
  objects_["0"][0]["cam_R_m2c"] = {1, 0, 0, 0, -1, 0, 0, 0, -1};
  WriteFiles();
  EXPECT_EQ(List().pictures[0].angle_deg, std::nullopt);
}

TEST_F(ListBopTest, LeavesOutWhatIsHidden) {
  const json hidden = {{"visib_fract", 0.05}};
  const json seen = {{"visib_fract", 0.5}};
  WriteText("1/scene_gt_info.json", json({{"0", {hidden, seen}}, {"10", {hidden}}}).dump());
  EXPECT_THAT(List().pictures, SizeIs(1));
  ASSERT_FALSE(List().notes.empty());
  EXPECT_EQ(List().notes[0].reason,
            "left out, the first of 2: less than 0.1 of the object is seen");
  EXPECT_THAT(List({.min_visible = 0.0}).pictures, SizeIs(3));
  EXPECT_THAT(Refusal({.min_visible = 0.9}), HasSubstr("no object to be seen; found 1 scenes"));
  WriteText("1/scene_gt_info.json", json({{"0", {hidden}}}).dump());
  EXPECT_THAT(Refusal(), HasSubstr("gt_info.json: at /0: 1 objects; scene_gt.json has 2"));
}

TEST_F(ListBopTest, NamesThePlaceOfAFault) {
  const auto refusal_of = [&](json& file, const char* pointer, const json& value) {
    const json before = file;
    file[json::json_pointer(pointer)] = value;
    WriteFiles();
    std::string refusal = Refusal();
    file = before;
    return refusal;
  };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {refusal_of(objects_, "/x", json::array()),
       "scene_gt.json: at /x: the key is not the number"},
      {refusal_of(objects_, "/-1", json::array()), "at /-1: the key is not the number"},
      {refusal_of(objects_, "/00", json::array()), "the picture is there twice"},
      {refusal_of(objects_, "/7", json::array()), "at /7: scene_camera.json has no such picture"},
      {refusal_of(objects_, "/0", 7), "at /0: 7; a list is due"},
      {refusal_of(objects_, "/0/0/obj_id", -1), "at /0/0/obj_id: -1; a whole number"},
      {refusal_of(objects_, "/0/0/cam_R_m2c/0", 3), "at /0/0/cam_R_m2c: not a rotation"},
      {refusal_of(objects_, "/0/0/cam_R_m2c", {1, 2}), "at /0/0/cam_R_m2c: 2 numbers; 9 are due"},
      {refusal_of(objects_, "/0/0/cam_t_m2c/1", 1e300), "a number beyond all bounds"},
      {refusal_of(cameras_, "/0/cam_K/0", 0), "scene_camera.json: at /0/cam_K: a focal length"},
      {refusal_of(cameras_, "/0/depth_scale", -1), "at /0/depth_scale: not in (0, 1000]"}};
  for (const auto& [refusal, message] : cases) EXPECT_THAT(refusal, HasSubstr(message));
}

TEST_F(ListBopTest, TellsOfASceneWithoutItsList) {
  WriteText("2/scene_camera.json", cameras_.dump());
  const SourceSet source = List();
  EXPECT_THAT(source.pictures, SizeIs(3));
  ASSERT_FALSE(source.notes.empty());
  EXPECT_EQ(source.notes[0].path, (tree_ / "2/scene_gt.json").string());
  EXPECT_EQ(source.notes[0].reason, "left out: no such list, which tells what the scene shows");
}

TEST_F(ListBopTest, LeavesOutWhatIsNotThereOrNotSeen) {
  const auto texts_of = [](const std::vector<Fault>& notes) {
    std::vector<std::string> texts;
    texts.reserve(notes.size());
    for (const Fault& note : notes) {
      texts.push_back(fs::path(note.path).filename().string() + ": " + note.reason);
    }
    return texts;
  };
  WriteImage("1/mask_visib/000000_000000.png", Image(12, 8));  // nothing is seen of the object
  fs::remove(tree_ / "1/mask_visib/000000_000001.png");
  const SourceSet source = List();
  EXPECT_THAT(
      texts_of(source.notes),
      ElementsAre(
          "000000_000001.png: left out: no such mask, of an object in scene_gt.json",
          "000010.jpg: imported without its cloud: no picture of the same number in depth/"));
  std::vector<Fault> notes;
  const ViewSet set =
      ImportViews(source, out_, {.on_note = [&](const Fault& note) { notes.push_back(note); }});
  EXPECT_THAT(set.items, SizeIs(1));
  ASSERT_THAT(notes, SizeIs(3));
  EXPECT_EQ(notes[2].path, "images/1/000000_000000.png");
  EXPECT_EQ(notes[2].reason, "left out: no object is seen: its mask has no pixel of one");
  EXPECT_THAT(FindFaults(ReadViewSet(out_)), IsEmpty());
  fs::remove(tree_ / "1/gray/000010.jpg");
  fs::remove_all(out_);
  EXPECT_THAT(Refusal(), HasSubstr("no object is seen in this view nor in the others"));
  fs::remove(tree_ / "1/rgb/000000.png");
  EXPECT_THAT(Refusal(), HasSubstr("000000.png: left out, the first of 3: no such picture of"));
}

TEST_F(ListBopTest, RefusesPicturesThatDoNotFit) {
  WriteImage("1/mask_visib/000000_000000.png", Image(8, 12));
  EXPECT_THAT(Refusal(), HasSubstr("the mask is 8x12 pixels, its picture 12x8"));
  AddMask("000000_000000", 5, 4);
  perception::WritePng16(tree_ / "1/depth/000000.png", BasicImage<std::uint16_t>(8, 12));
  EXPECT_THAT(Refusal(), HasSubstr("000000.png: the depth is 8x12 pixels, its picture 12x8"));
  fs::remove(tree_ / "1/rgb/000000.png");
  fs::remove(tree_ / "1/scene_camera.json");
  EXPECT_THAT(Refusal(), HasSubstr("scene_camera.json: "));
  fs::remove(tree_ / "1/scene_gt.json");
  EXPECT_THAT(Refusal(), HasSubstr("no object to be seen; found 0 scenes (scene_gt.json)"));
  EXPECT_THAT(Refusal({.min_visible = 2}), HasSubstr("BopOptions.min_visible is 2"));
  EXPECT_THAT(Refusal({.margin_px = -1}), HasSubstr("BopOptions.margin_px is -1"));
}

}  // namespace
}  // namespace handcraft::datasets
