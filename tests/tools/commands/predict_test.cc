// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/organised_cloud.h"
#include "lib/core/file.h"
#include "lib/core/rng.h"
#include "lib/perception/image_io.h"
#include "tests/lib/perception/table_scene.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"
#include "tests/tools/support/small_camera_file.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;
using ::testing::StartsWith;

// A gray picture of one pixel, 16 bits deep: python3 zlib and struct, chunks IHDR, IDAT, IEND.
constexpr std::array<std::uint8_t, 68> kPng16Bit = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48,
    0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x10, 0x00, 0x00, 0x00,
    0x00, 0x6a, 0xee, 0x47, 0x16, 0x00, 0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78,
    0xda, 0x63, 0x60, 0x64, 0x02, 0x00, 0x00, 0x07, 0x00, 0x04, 0xe5, 0xed, 0x94, 0xcf,
    0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

class PredictTest : public testing::ImageSetTest {
 protected:
  void SetUp() override {
    ImageSetTest::SetUp();
    testing::TrainGraspPoints(set_, folder_ / "grasp");
  }

  // Runs `predict` with a model and inputs of the folder; options follow.
  [[nodiscard]] Outcome Predict(const std::vector<std::string>& model_and_inputs,
                                const std::string& options = "--min-probability 0.3") const {
    std::string line = "predict";
    for (const std::string& name : model_and_inputs) line += " " + (folder_ / name).string();
    return RunLine(line + " " + options);
  }

  [[nodiscard]] std::string OutOption() const { return " --out " + (folder_ / "out").string(); }
};

TEST_F(PredictTest, RanksGraspPointsBestFirst) {
  const Outcome outcome = Predict({"grasp", "set/p4.png"}, "--min-probability 0.3 --top 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  ASSERT_EQ(json["predictions"].size(), 1U);
  EXPECT_EQ(json["predictions"][0]["width_px"], 64);
  const auto& points = json["predictions"][0]["grasp_points"];
  ASSERT_GE(points.size(), 2U);
  ASSERT_LE(points.size(), 3U);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GT(points[i]["probability"].get<double>(), 0.3);
    if (i > 0) {
      EXPECT_GE(points[i - 1]["probability"], points[i]["probability"]);
    }
  }
}

TEST_F(PredictTest, PrintsATable) {
  const Outcome outcome = Predict({"grasp", "set/p4.png", "set/p5.png"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("image"), HasSubstr("u [px]"), HasSubstr("p5.png     1  ")));
}

TEST_F(PredictTest, WritesJsonAndOverlayOfEachPicture) {
  const Outcome outcome =
      Predict({"grasp", "set/p4.png", "set/p5.png"}, "--min-probability 0.3" + OutOption());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(NumEntries(folder_ / "out"), 4U);
  const auto json = nlohmann::json::parse(ReadTextFile(folder_ / "out/p4.grasp_points.json"));
  EXPECT_FALSE(json["grasp_points"].empty());
  const Image overlay = perception::ReadImage(folder_ / "out/p4.grasp_points.png");
  EXPECT_EQ(overlay.width(), 64);
  EXPECT_EQ(overlay.height(), 48);
}

TEST_F(PredictTest, TakesPicturesOfAnySize) {
  perception::WritePng(folder_ / "1x1.png", Image(1, 1, 3, 9));
  perception::WritePng(folder_ / "4x4.png", Image(4, 4, 3, 9));
  perception::WritePng(folder_ / "wide.png", Image(10000, 3, 1, 9));
  const Outcome outcome =
      Predict({"grasp", "1x1.png", "4x4.png", "wide.png"}, "--min-probability 0");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(PredictTest, SaysThatNothingIsGoodEnough) {
  const Outcome outcome =
      Predict({"grasp", "set/p4.png"}, "--min-probability 0.999999" + OutOption());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.out, HasSubstr("-"));
  EXPECT_THAT(outcome.err, HasSubstr("no grasp point above probability 0.999999"));
  EXPECT_EQ(NumEntries(folder_ / "out"), 2U);
}

TEST_F(PredictTest, LeavesNothingWhenOnePictureIsWrong) {
  std::vector<std::uint8_t> corrupt = ReadFile(folder_ / "set/p4.png");
  corrupt.resize(200);
  WriteFileAtomically(folder_ / "corrupt.png", corrupt);
  WriteFileAtomically(folder_ / "empty.png", "");
  WriteFileAtomically(folder_ / "text.png", "this is no picture");
  std::filesystem::create_directory(folder_ / "folder.png");
  WriteFileAtomically(folder_ / "16bit.png", kPng16Bit);
  for (const char* wrong :
       {"corrupt.png", "empty.png", "text.png", "folder.png", "16bit.png", "missing.png"}) {
    const Outcome outcome =
        Predict({"grasp", "set/p4.png", wrong}, "--min-probability 0.3" + OutOption());
    EXPECT_EQ(outcome.code, 3) << wrong;
    EXPECT_EQ(outcome.out, "") << wrong;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("handcraft: error: "), HasSubstr(wrong)));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << wrong;
  }
}

TEST_F(PredictTest, RefusesAGrayPictureForAColourModel) {
  testing::TrainGraspPoints(
      folder_ / "set", folder_ / "colour", "filters=edges+chroma,window=1,energy=log");
  perception::WritePng(folder_ / "gray.png", Image(20, 20, 1, 9));
  const Outcome outcome = Predict({"colour", "gray.png"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("gray.png"), HasSubstr("colour")));
}

TEST_F(PredictTest, RefusesWhatIsNoModel) {
  EXPECT_EQ(Predict({"set/p4.png", "set/p4.png"}).code, 3);
  EXPECT_EQ(Predict({"missing", "set/p4.png"}).code, 3);
}

TEST_F(PredictTest, RefusesTwoInputsForOneFile) {
  std::filesystem::create_directory(folder_ / "other");
  std::filesystem::copy_file(folder_ / "set/p4.png", folder_ / "other/p4.png");
  const Outcome outcome =
      Predict({"grasp", "set/p4.png", "other/p4.png"}, "--min-probability 0.3" + OutOption());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("two inputs would write this file"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(PredictTest, RefusesAPlaceItCannotWriteTo) {
  WriteFileAtomically(folder_ / "out", "a file in the way");
  const Outcome outcome = Predict({"grasp", "set/p4.png"}, "--min-probability 0.3" + OutOption());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("cannot create the folder"));
}

TEST_F(PredictTest, RefusesWrongOptions) {
  EXPECT_EQ(Predict({"grasp", "set/p4.png"}, "--min-probability 1").code, 2);
  EXPECT_EQ(Predict({"grasp", "set/p4.png"}, "--top 0").code, 2);
  EXPECT_EQ(Predict({"grasp", "set/p4.png"}, "--suppression-radius -1").code, 2);
}

// A picture of a bright block on a dark table, and their cloud.
class PredictRegionTest : public PredictTest {
 protected:
  void SetUp() override {
    PredictTest::SetUp();
    perception::WritePng(folder_ / "block.png", perception::testing::PictureOfBlock(3));
    WriteCloud(perception::testing::TableWithBlock());
  }

  void WriteCloud(const perception::testing::Cloud& cloud) const {
    datasets::WritePcd(folder_ / "block.pcd",
                       {.width = cloud.width, .height = cloud.height, .points = cloud.points});
  }

  [[nodiscard]] Outcome PredictBlock(const std::string& options) const {
    return Predict({"grasp", "block.png"},
                   "--min-probability 0 --cloud " + (folder_ / "block.pcd").string() + options);
  }
};

TEST_F(PredictRegionTest, FindsGraspPointsOnTheObjectsEdgesAlone) {
  const Outcome outcome = PredictBlock(" --top 1000 --suppression-radius 0 --json" + OutOption());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out)["predictions"][0];
  EXPECT_EQ(json["search"]["found"], true);
  EXPECT_EQ(json["search"]["stages"][2]["num_pixels"], 400);
  EXPECT_EQ(json["search"]["stages"].back()["name"], "scored");
  ASSERT_EQ(json["grasp_points"].size(), json["search"]["stages"].back()["num_pixels"]);
  for (const auto& point : json["grasp_points"]) {
    EXPECT_NEAR(point["u_px"].get<int>(), 39.5, 12.0);
    EXPECT_NEAR(point["v_px"].get<int>(), 29.5, 12.0);
  }
  EXPECT_EQ(perception::ReadImage(folder_ / "out/block.grasp_points.png").width(), 80);
}

TEST_F(PredictRegionTest, PrintsTheStages) {
  const Outcome outcome = PredictBlock("");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("rank"),
                    HasSubstr("\n\nstage             pixels  time [ms]\npicture             4800"),
                    HasSubstr("off the table        400"),
                    HasSubstr("scored")));
}

// What is seen twice, 11 px apart, is a board 1.43 m away that faces the camera.
TEST_F(PredictTest, TellsTheTimeOfMatchingAPair) {
  Rng rng = Rng::Stream(1, "predict_pair");
  Image left(160, 120, 3);
  for (int i = 0; i < 3 * 160 * 120; ++i) {
    left.Row(0)[i] = static_cast<std::uint8_t>(rng.UniformInt(256));
  }
  Image right(160, 120, 3);
  for (int v = 0; v < 120; ++v) std::copy_n(left.Row(v) + 3 * 11, 3 * 149, right.Row(v));
  perception::WritePng(folder_ / "left.png", left);
  perception::WritePng(folder_ / "right.png", right);
  const std::string camera = testing::CameraFile(folder_.path(), "baseline_m = 0.12\n");
  const std::string options =
      "--min-probability 0 --camera " + camera + " --right " + (folder_ / "right.png").string();
  const Outcome outcome = Predict({"grasp", "left.png"}, options + " --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto stages = nlohmann::json::parse(outcome.out)["predictions"][0]["search"]["stages"];
  EXPECT_EQ(stages[0]["name"], "picture");
  EXPECT_EQ(stages[1]["name"], "matched");
  EXPECT_EQ(stages[1]["num_pixels"], stages[2]["num_pixels"]);
  EXPECT_GT(stages[1]["time_ms"].get<double>(), 0.0);
  EXPECT_EQ(stages[2]["name"], "measured");
  EXPECT_THAT(Predict({"grasp", "left.png"}, options).out, HasSubstr("\nmatched "));
}

TEST_F(PredictRegionTest, SaysThatThereIsNoTable) {
  const Outcome outcome = PredictBlock(" --up 1 0 0");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("block.png: No support was found"));
}

TEST_F(PredictRegionTest, SaysThatNothingStandsOnTheTable) {
  WriteCloud(perception::testing::Table(80, 60));
  const Outcome outcome = PredictBlock(OutOption());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("block.png"), HasSubstr("Every measured point lies on the support")));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(PredictRegionTest, SaysThatTheCloudIsEmpty) {
  WriteFileAtomically(folder_ / "block.pcd",
                      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nHEIGHT 1\n"
                      "POINTS 0\nDATA ascii\n");
  const Outcome outcome = PredictBlock("");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("block.png"));
}

TEST_F(PredictRegionTest, RefusesOptionsThatDoNotFit) {
  EXPECT_EQ(PredictBlock(" --camera c.toml").code, 2);
  EXPECT_EQ(PredictBlock(" --up 0 0").code, 2);
  EXPECT_EQ(PredictBlock(" --up-angle 91").code, 2);
  EXPECT_EQ(PredictBlock(" --table-distance 0").code, 2);
  EXPECT_EQ(PredictBlock(" --right r.png --camera c.toml").code, 2);
}

TEST_F(PredictRegionTest, NeverOverwritesTheCloud) {
  const auto cloud = ReadFile(folder_ / "block.pcd");
  std::filesystem::create_directory(folder_ / "out");
  std::filesystem::rename(folder_ / "block.pcd", folder_ / "out/block.grasp_points.json");
  const Outcome outcome =
      Predict({"grasp", "block.png"},
              "--cloud " + (folder_ / "out/block.grasp_points.json").string() + OutOption());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would overwrite the input"));
  EXPECT_EQ(ReadFile(folder_ / "out/block.grasp_points.json"), cloud);
}

TEST_F(PredictTest, RefusesPictureOptionsForATable) {
  testing::WriteTable(folder_ / "t.csv");
  testing::TrainLogistic(folder_ / "t.csv", folder_ / "logistic");
  for (const std::string option : {"--top", "--min-probability", "--suppression-radius"}) {
    // As its default, which changes nothing either.
    const std::string value = option == "--min-probability" ? " 0.9" : " 15";
    const Outcome outcome = Predict({"logistic", "t.csv"}, option + value);
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err,
                HasSubstr(option + " is about pictures: it needs a grasp-point model"));
  }
}

TEST_F(PredictTest, NeverOverwritesItsInputs) {
  testing::WriteTable(folder_ / "t.csv");
  testing::TrainLogistic(folder_ / "t.csv", folder_ / "logistic");
  std::filesystem::copy_file(folder_ / "set/p4.png", folder_ / "set/p5.grasp_points.png");
  std::filesystem::copy_file(folder_ / "grasp", folder_ / "set/p5.grasp_points.json");
  std::filesystem::copy_file(folder_ / "t.csv", folder_ / "set/t.probabilities.csv");
  const auto expect_refused = [&](const std::vector<std::string>& model_and_inputs,
                                  const std::string& file) {
    const auto before = ReadFile(folder_ / file);
    const Outcome outcome = Predict(model_and_inputs, "--out " + (folder_ / "set").string());
    EXPECT_EQ(outcome.code, 2) << file;
    EXPECT_THAT(outcome.err, HasSubstr("would overwrite the input"));
    EXPECT_EQ(ReadFile(folder_ / file), before);
  };
  expect_refused({"grasp", "set/p5.png", "set/p5.grasp_points.png"}, "set/p5.grasp_points.png");
  expect_refused({"set/p5.grasp_points.json", "set/p5.png"}, "set/p5.grasp_points.json");
  expect_refused({"logistic", "t.csv", "set/t.probabilities.csv"}, "set/t.probabilities.csv");
}

TEST_F(PredictTest, GivesProbabilitiesOfATable) {
  testing::WriteTable(folder_ / "t.csv");
  testing::TrainLogistic(folder_ / "t.csv", folder_ / "logistic");
  // Columns in another order, and one more.
  WriteFileAtomically(folder_ / "new.csv", "x2,x1,x3\n0,3,9\n0,-3,9\n");
  const Outcome outcome = Predict({"logistic", "new.csv"}, "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["predictions"][0]["positive_label"], "yes");
  const auto& probabilities = json["predictions"][0]["probabilities"];
  EXPECT_GT(probabilities[0].get<double>(), 0.5);
  EXPECT_LT(probabilities[1].get<double>(), 0.5);
  EXPECT_THAT(Predict({"logistic", "new.csv"}, "").out, StartsWith("probability of yes\n0."));
  EXPECT_EQ(Predict({"logistic", "new.csv"}, OutOption()).code, 0);
  EXPECT_THAT(ReadTextFile(folder_ / "out/new.probabilities.csv"),
              StartsWith("probability of yes\n0."));
}

TEST_F(PredictTest, RefusesAPictureForATableModel) {
  testing::WriteTable(folder_ / "t.csv");
  testing::TrainLogistic(folder_ / "t.csv", folder_ / "logistic");
  const Outcome outcome = Predict({"logistic", "set/p4.png"}, "");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("p4.png"));
}

}  // namespace
}  // namespace handcraft::tools
