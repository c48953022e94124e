// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/object_clouds.h"
#include "lib/core/file.h"
#include "lib/model_io/object_class_models.h"
#include "lib/perception/image_io.h"
#include "tests/datasets/small_views.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;

const std::string kArm = HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/right_arm.toml";

class PlanGrasp : public ::testing::Test {
 protected:
  void SetUp() override {
    datasets::testing::WriteSmallSet(set_, {0.0, 30.0}, 0.0);
    TrainLibrary("0.2");
    WriteFileAtomically(folder_ / "plan.toml",
                        "[grasp_point]\npixel = [8, 5]\n[object_class]\nname = \"board\"\n"
                        "[grasp_library]\nmodel = \"library.safetensors\"\n[robot]\nfile = \"" +
                            std::filesystem::absolute(kArm).string() + "\"\n");
  }

  void TrainLibrary(const std::string& max_distance_m) const {
    ASSERT_EQ(
        RunLine("train grasp-library --threads 1 --views " + set_.string() + " --demonstrations " +
                set_.string() + " --robot " + kArm + " --max-distance-m " + max_distance_m +
                " --out " + (folder_ / "library.safetensors").string())
            .code,
        0);
  }
  [[nodiscard]] Outcome Plan(const std::string& options) const {
    return RunLine("plan grasp --config " + (folder_ / "plan.toml").string() + " --image " +
                   (set_ / "images/board0.png").string() + " --cloud " +
                   (set_ / "clouds/board0.pcd").string() + " --mask " +
                   (set_ / "masks/board0.png").string() + " " + options);
  }

  handcraft::testing::TemporaryDirectory folder_;
  std::filesystem::path set_ = folder_ / "set";
};

TEST_F(PlanGrasp, PrintsJointsAndTheTimeOfEachLayer) {
  const Outcome outcome = Plan("");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("board turned by 0 degrees"),
                    HasSubstr("right_j7"),
                    HasSubstr("nearest demonstration"),
                    HasSubstr("inverse kinematics")));
}

TEST_F(PlanGrasp, TellsMachinesAll) {
  const Outcome outcome = Plan("--json --class wedge --grasp-point 7,5 --neighbours 2");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["class"], "wedge");
  EXPECT_EQ(json["grasp_point"]["u_px"], 7);
  EXPECT_EQ(json["joints"].size(), 7U);
  EXPECT_EQ(json["stages"].size(), 5U);
  EXPECT_TRUE(json["solved"].get<bool>());
  EXPECT_FALSE(json["rejected"].get<bool>());
  EXPECT_EQ(json["rank"], 0);
  EXPECT_EQ(json["num_attempts"], 1);
}

TEST_F(PlanGrasp, RefusesWrongUseAndUnknownClasses) {
  EXPECT_EQ(Plan("--grasp-point 7").code, 2);
  EXPECT_EQ(Plan("--neighbours 33").code, 2);
  EXPECT_EQ(Plan("--attempts 65").code, 2);
  EXPECT_EQ(Plan("--attempt-distance-m -1").code, 2);
  const Outcome unknown = Plan("--class teapot");
  EXPECT_EQ(unknown.code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("there are: board, wedge"));
  const Outcome twice = Plan("--grasp-point 7,5 --grasp-points m.safetensors");
  EXPECT_EQ(twice.code, 2);
  EXPECT_THAT(twice.err, HasSubstr("told twice"));
}

// The whole chain: a classifier trained with novel views, and a scene of something novel.
TEST_F(PlanGrasp, RefusesAnObjectThatIsNoneOfTheClassesOrTakesTheNearest) {
  const std::string classifier = (folder_ / "classes.safetensors").string();
  ASSERT_EQ(testing::RunArgs({"train",
                              "object-class",
                              set_.string(),
                              "--split",
                              "",
                              "--grid-size",
                              "4",
                              "--outlier-step",
                              "0",
                              "--folds",
                              "0",
                              "--out",
                              classifier})
                .code,
            0);
  const Outcome sure = Plan("--json --classifier " + classifier);
  ASSERT_EQ(sure.code, 0) << sure.err;
  const auto before = nlohmann::json::parse(sure.out);
  EXPECT_EQ(before["class"], "board");
  EXPECT_FALSE(before["class_rejected"].get<bool>());
  EXPECT_FALSE(before.contains("class_rejection_threshold"));
  // The same with a threshold that the scene does not reach.
  model_io::ObjectClassModel model =
      model_io::ReadObjectClassModel(model_io::Parse(ReadFile(classifier), classifier));
  const double threshold = before["class_margin"].get<double>() + 0.5;
  model.svm.rejection_threshold = threshold;
  const datasets::MaskedCloud example =
      datasets::ReadObjectCloud(datasets::ReadViewSet(set_), 0, {.outlier_step = 0.0});
  WriteFileAtomically(
      classifier, model_io::Serialise(model_io::MakeObjectClassModel(model, example.View(), {})));
  const std::string out = (folder_ / "out").string();
  const Outcome refused = Plan("--json --out " + out + " --classifier " + classifier);
  EXPECT_EQ(refused.code, 4);
  EXPECT_EQ(refused.out, "");
  EXPECT_THAT(refused.err,
              AllOf(HasSubstr("none of the model's classes"),
                    HasSubstr("the nearest is 'board'"),
                    HasSubstr("--nearest-class")));
  EXPECT_FALSE(std::filesystem::exists(out));
  const Outcome nearest = Plan("--json --nearest-class --classifier " + classifier);
  ASSERT_EQ(nearest.code, 0) << nearest.err;
  const auto after = nlohmann::json::parse(nearest.out);
  EXPECT_TRUE(after["class_rejected"].get<bool>());
  EXPECT_EQ(after["class_rejection_threshold"], threshold);
  EXPECT_EQ(after["joints"], before["joints"]);
  EXPECT_THAT(Plan("--nearest-class --classifier " + classifier).out,
              HasSubstr("board, the nearest of the classes, though it is none of these, turned"));
  // The same by a line of the plan file.
  std::string plan = ReadTextFile(folder_ / "plan.toml");
  plan.replace(plan.find("name = \"board\""), 14, "none_of_these = \"nearest\"");
  WriteFileAtomically(folder_ / "plan.toml", plan);
  EXPECT_EQ(Plan("--classifier " + classifier).code, 0);
}

TEST_F(PlanGrasp, TellsWhichFileMayAllowAnotherArm) {
  const std::string panda = HANDCRAFT_SOURCE_DIR "/models/robots/franka_panda/panda.toml";
  EXPECT_THAT(Plan("--robot " + panda).err,
              HasSubstr("any_arm = true in [robot] of the plan file (--config)"));
  EXPECT_THAT(Plan("--attempt-distance-m -1").err,
              HasSubstr("--attempt-distance-m: -1 given; it must be from 0 to 1000"));
}

TEST_F(PlanGrasp, RefusesAGraspThatIsFarFromEveryDemonstration) {
  TrainLibrary("0.0001");
  const Outcome outcome = Plan("");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("the library allows 0.0001 m"));
}

TEST_F(PlanGrasp, SaysThatTheArmDoesNotReach) {
  datasets::OrganisedCloud cloud = datasets::ReadPcd(set_ / "clouds/board0.pcd");
  for (Eigen::Vector3f& point : cloud.points) point.x() += 4.0F;
  datasets::WritePcd(set_ / "clouds/board0.pcd", cloud);
  const Outcome outcome = Plan("--json --attempts 2");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("the 2 nearest demonstrated grasps"),
                    HasSubstr("the best attempt is off by")));
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_FALSE(json["solved"].get<bool>());
  EXPECT_EQ(json["num_attempts"], 2);
  EXPECT_GT(json["position_error_m"], 3.0);
}

// The pose that is nearest to pixel 8,5 is turned to come from below the table.
TEST_F(PlanGrasp, TellsWhichDemonstrationWasTaken) {
  const auto json = [this] { return nlohmann::json::parse(Plan("--json").out); };
  const int nearest = json()["demonstration"];
  datasets::DemonstrationSet shown = datasets::ReadDemonstrationSet(set_);
  shown.items.at(static_cast<std::size_t>(nearest)).pose.rotation = Eigen::Quaterniond::Identity();
  datasets::WriteDemonstrations(shown);
  TrainLibrary("0.2");
  EXPECT_EQ(json()["rank"], 1);
  EXPECT_EQ(json()["num_attempts"], 2);
  EXPECT_NE(json()["demonstration"], nearest);
  EXPECT_THAT(Plan("").out, HasSubstr("1 nearer out of reach, next nearest demonstration"));
  EXPECT_EQ(Plan("--attempts 1").code, 4);
  EXPECT_EQ(Plan("--attempt-distance-m 0.0001").code, 4);
}

// A pinhole camera at the origin of the base frame sees a slanted plane.
TEST_F(PlanGrasp, DrawsTheHand) {
  datasets::OrganisedCloud cloud;
  cloud.width = 64;
  cloud.height = 48;
  // Looks along base x: camera z is base x, camera x is base −y, camera y is base −z.
  cloud.base_from_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  cloud.base_from_camera.translation() = Eigen::Vector3f(-0.5F, 0.0F, 0.3F);
  Image mask(64, 48);
  for (int v = 0; v < 48; ++v) {
    for (int u = 0; u < 64; ++u) {
      const float depth_m = 0.5F + 0.002F * static_cast<float>(u);
      cloud.points.emplace_back(cloud.base_from_camera *
                                Eigen::Vector3f(depth_m * static_cast<float>(u - 32) / 60.0F,
                                                depth_m * static_cast<float>(v - 24) / 60.0F,
                                                depth_m));
      if (u > 20 && u < 44 && v > 14 && v < 34) mask.At(u, v) = 255;
    }
  }
  datasets::WritePcd(set_ / "clouds/board0.pcd", cloud);
  const Image picture(64, 48, 3, 100);
  perception::WritePng(set_ / "images/board0.png", picture);
  perception::WritePng(set_ / "masks/board0.png", mask);
  const Outcome outcome =
      Plan("--grasp-point 32,24 --out " + (folder_ / "out").string() + " --json");
  EXPECT_EQ(NumEntries(folder_ / "out"), 3U) << outcome.err;
  const Image overlay = perception::ReadImage(folder_ / "out" / "overlay.png");
  EXPECT_EQ(overlay.width(), 64);
  EXPECT_NE(overlay.values(), picture.values());
  const Image close_up = perception::ReadImage(folder_ / "out" / "close_up.png");
  EXPECT_EQ(close_up.width(), 640);
  EXPECT_EQ(close_up.height(), 480);
  EXPECT_EQ(nlohmann::json::parse(ReadTextFile(folder_ / "out" / "plan.json"))["class"], "board");
}

}  // namespace
}  // namespace handcraft::tools
