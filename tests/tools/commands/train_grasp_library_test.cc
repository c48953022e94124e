// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "tests/datasets/small_views.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

const std::string kArm = HANDCRAFT_SOURCE_DIR "/models/robots/dual_wam/right_arm.toml";

class TrainGraspLibrary : public ::testing::Test {
 protected:
  void SetUp() override { datasets::testing::WriteSmallSet(set_, {0.0, 30.0, 60.0}); }

  [[nodiscard]] Outcome Train(const std::string& options, int num_threads = 1) const {
    return RunLine("train grasp-library --threads " + std::to_string(num_threads) + " --views " +
                   set_.string() + " --demonstrations " + set_.string() + " " + options);
  }

  handcraft::testing::TemporaryDirectory folder_;
  std::filesystem::path set_ = folder_ / "set";
  std::string model_ = (folder_ / "m.safetensors").string();
};

TEST_F(TrainGraspLibrary, WritesAModelThatTheRobotLoads) {
  const Outcome outcome = Train("--robot " + kArm + " --out " + model_);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("board"), HasSubstr("wedge"), HasSubstr("written to")));
  const Outcome checked = RunLine("check-model " + model_);
  EXPECT_EQ(checked.code, 0) << checked.err;
  EXPECT_THAT(checked.out, HasSubstr("is a grasp_library model"));
  const Outcome inspected = RunLine("inspect " + model_);
  EXPECT_THAT(inspected.out,
              AllOf(HasSubstr("right_j1 right_j2"), HasSubstr("view_normals"), HasSubstr("xyzw")));
}

TEST_F(TrainGraspLibrary, TellsMachinesWhatItHolds) {
  const Outcome outcome = Train("--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["classes"][1]["class"], "wedge");
  EXPECT_EQ(json["classes"][1]["views"], 3);
  EXPECT_EQ(json["classes"][1]["angles"], 3);
  EXPECT_EQ(json["classes"][1]["poses"], 9);
}

TEST_F(TrainGraspLibrary, WritesThePrintedRuleIfAsked) {
  ASSERT_EQ(Train("--moments printed --candidates 6 --angle-weight 0 --out " + model_).code, 0);
  const auto json = nlohmann::json::parse(RunLine("inspect --json " + model_).out);
  EXPECT_EQ(json["metadata"]["hc.training.compared_moments"], "printed");
  EXPECT_EQ(json["metadata"]["hc.training.num_candidates"], "6");
}

TEST_F(TrainGraspLibrary, TheNumberOfThreadsChangesNoByte) {
  ASSERT_EQ(Train("--out " + model_).code, 0);
  const auto one = ReadFile(model_);
  ASSERT_EQ(Train("--out " + model_, 2).code, 0);
  EXPECT_EQ(ReadFile(model_), one);
}

TEST_F(TrainGraspLibrary, RefusesWrongUse) {
  EXPECT_EQ(Train("--candidates 65").code, 2);
  EXPECT_EQ(Train("--moments some").code, 2);
  EXPECT_EQ(Train("--out " + (set_ / "views.csv").string()).code, 2);
  const Outcome missing = RunLine("train grasp-library --views /nowhere --demonstrations /nowhere");
  EXPECT_EQ(missing.code, 3);
  const Outcome predict = [&] {
    EXPECT_EQ(Train("--out " + model_).code, 0);
    return RunLine("predict " + model_ + " " + (set_ / "views.csv").string());
  }();
  EXPECT_EQ(predict.code, 3) << predict.out;
}

}  // namespace
}  // namespace handcraft::tools
