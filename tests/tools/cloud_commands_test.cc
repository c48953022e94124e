// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/cloud_commands.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "tests/datasets/some_object_views.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;
using Json = nlohmann::ordered_json;

// A model of "ball", "ramp" and "post" and the views it was trained on.
class CloudCommands : public ::testing::Test {
 protected:
  CloudCommands() {
    handcraft::testing::WriteObjectViews(folder_ / "set", {"ball", "ramp", "post"});
    const Outcome trained = RunLine("train object-class " + Path("set") + " --grid-size 6 --out " +
                                    Path("m.safetensors"));
    EXPECT_EQ(trained.code, 0) << trained.err;
  }

  [[nodiscard]] std::string Path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] Outcome Predict(const std::string& rest) const {
    return RunLine("predict " + Path("m.safetensors") + " " + rest);
  }
  [[nodiscard]] Outcome Evaluate(const std::string& rest) const {
    return RunLine("evaluate " + Path("m.safetensors") + " " + rest);
  }

  handcraft::testing::TemporaryDirectory folder_;
};

TEST_F(CloudCommands, EvaluateCountsViews) {
  handcraft::testing::WriteObjectViews(folder_ / "test", {"ball", "post"}, 4, 2);
  const Outcome text = Evaluate(Path("test"));
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(
      text.out,
      AllOf(HasSubstr("predicted ramp"), HasSubstr("8 of 8 views right: accuracy 100.00 %")));
  const Json json = Json::parse(Evaluate(Path("test") + " --split train --json").out);
  EXPECT_EQ(json["accuracy"], 1.0);
  EXPECT_EQ(json["confusion"][1][2], 4);
}

TEST_F(CloudCommands, EvaluateNamesUnknownClassesAndSplits) {
  datasets::ViewSet set = handcraft::testing::WriteObjectViews(folder_ / "test", {"ball"}, 3, 2);
  for (datasets::ObjectView& view : set.items) view.object_class = "orange";
  datasets::WriteViews(set);
  const Outcome unknown = Evaluate(Path("test"));
  EXPECT_EQ(unknown.code, 3);
  EXPECT_THAT(unknown.err, HasSubstr("the class 'orange' is not one of the model's"));
  EXPECT_THAT(Evaluate(Path("test") + " --counts-as orange=ball").out, HasSubstr("3 of 3 views"));
  const Outcome wrong = Evaluate(Path("test") + " --counts-as orange");
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err,
              AllOf(HasSubstr("CLASS=CLASS_OF_THE_MODEL is due"), HasSubstr("=none of these")));
  EXPECT_THAT(unknown.err, HasSubstr("'orange=none of these'"));
  // A model without a threshold takes all for one of its classes, and that is said.
  const Outcome none = testing::RunArgs(
      {"evaluate", Path("m.safetensors"), Path("test"), "--counts-as=orange=none of these"});
  ASSERT_EQ(none.code, 0) << none.err;
  EXPECT_THAT(none.out,
              AllOf(HasSubstr("0 of 3 views right"), HasSubstr("The model has no threshold")));
  EXPECT_THAT(Evaluate(Path("test") + " --split test").err, HasSubstr("no view is in the split"));
  const Outcome threshold = Evaluate(Path("test") + " --top 3");
  EXPECT_EQ(threshold.code, 2);
}

TEST_F(CloudCommands, PredictUnderAMask) {
  const Outcome predicted =
      Predict(Path("set/post_1.pcd") + " --object-mask " + Path("set/post_1_mask.png") + " --json");
  ASSERT_EQ(predicted.code, 0) << predicted.err;
  const Json json = Json::parse(predicted.out);
  EXPECT_EQ(json["predictions"][0]["class"], "post");
  EXPECT_EQ(json["predictions"][0]["decision_values"].size(), 3U);
  const Outcome text = Predict(Path("set/ramp_1.pcd") + " --object-mask " +
                               Path("set/ramp_1_mask.png") + " --out " + Path("p"));
  ASSERT_EQ(text.code, 0) << text.err;
  EXPECT_THAT(text.out, HasSubstr("ramp"));
  EXPECT_EQ(Json::parse(ReadTextFile(folder_ / "p" / "ramp_1.object_class.json"))["class"], "ramp");
}

TEST_F(CloudCommands, PredictFindsWhatStandsOnTheTable) {
  // A level table with a ball's cap above its middle.
  datasets::OrganisedCloud cloud{.width = 60, .height = 60};
  for (int v = 0; v < 60; ++v) {
    for (int u = 0; u < 60; ++u) {
      const float x = 0.01F * static_cast<float>(u - 30);
      const float y = 0.01F * static_cast<float>(v - 30);
      const float cap = 0.12F - 6.0F * (x * x + y * y);
      cloud.points.emplace_back(x, y, cap > 0.02F ? cap : 0.0F);
    }
  }
  datasets::WritePcd(folder_ / "table.pcd", cloud);
  const Outcome found = Predict(Path("table.pcd"));
  EXPECT_EQ(found.code, 0) << found.err;
  for (Eigen::Vector3f& point : cloud.points) point.z() = 0.0F;
  datasets::WritePcd(folder_ / "empty.pcd", cloud);
  const Outcome nothing = Predict(Path("empty.pcd"));
  EXPECT_EQ(nothing.code, 4);
  EXPECT_THAT(nothing.err, HasSubstr("fewer than three points of an object"));
}

TEST_F(CloudCommands, PredictRefusesOtherClouds) {
  datasets::OrganisedCloud row{.width = 5, .height = 1};
  row.points.assign(5, Eigen::Vector3f::Zero());
  datasets::WritePcd(folder_ / "row.pcd", row);
  EXPECT_THAT(Predict(Path("row.pcd")).err, HasSubstr("no rows and columns"));
  datasets::WritePcd(folder_ / "small.pcd", {.width = 2, .height = 2, .points = {4, {0, 0, 0}}});
  const Outcome other =
      Predict(Path("small.pcd") + " --object-mask " + Path("set/post_1_mask.png"));
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("the mask"));
}

TEST_F(CloudCommands, OptionsForCloudsAreRefusedByOtherModels) {
  WriteFileAtomically(folder_ / "rows.safetensors",
                      model_io::Serialise(handcraft::testing::SomeSvmModel()));
  WriteFileAtomically(folder_ / "t.csv", "length_m,width_m,object\n1,2,mug\n");
  const std::string rest = Path("rows.safetensors") + " " + Path("t.csv");
  for (const std::string& line :
       {"evaluate " + rest + " --counts-as a=mug", "predict " + rest + " --object-mask m.png"}) {
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_THAT(outcome.err, HasSubstr("is for models of object classes"));
  }
}

TEST(CloudTable, ShowsRejectedOnes) {
  const Json predictions = {
      {{"cloud", "a.pcd"}, {"class", nullptr}, {"nearest_class", "mug"}, {"margin", 0.5}}};
  EXPECT_THAT(CloudTable(predictions),
              AllOf(HasSubstr("none of these; the nearest is mug"), HasSubstr("0.5000")));
}

}  // namespace
}  // namespace handcraft::tools
