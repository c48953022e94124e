// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/cloud_evaluation.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/loaded_model.h"
#include "experiments/object_classes/object_class_training.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/datasets/some_object_views.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::TemporaryDirectory;
using handcraft::testing::WriteObjectViews;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class EvaluateCloudsTest : public ::testing::Test {
 protected:
  EvaluateCloudsTest() {
    ObjectClassOptions options;
    options.descriptor.grid_size = 6;
    const datasets::ViewSet set = WriteObjectViews(folder_ / "train", {"ball", "ramp", "post"});
    const model_io::ObjectClassModel made = TrainObjectClasses(set, options).model;
    const datasets::MaskedCloud object = datasets::ReadObjectCloud(set, 0);
    bytes_ = model_io::Serialise(model_io::MakeObjectClassModel(made, object.View(), {}));
    model_ = LoadModel(bytes_);
  }

  TemporaryDirectory folder_;
  std::vector<std::uint8_t> bytes_;
  LoadedModel model_;
};

TEST_F(EvaluateCloudsTest, CountsViews) {
  const datasets::ViewSet set = WriteObjectViews(folder_ / "test", {"post", "ball"}, 4, 2);
  const CloudEvaluation evaluation = EvaluateClouds(model_.get(), set, {});
  EXPECT_EQ(evaluation.num_views, 8U);
  EXPECT_EQ(evaluation.num_correct, 8U);
  EXPECT_THAT(evaluation.truths, ElementsAre("post", "ball"));
  EXPECT_THAT(evaluation.classes, ElementsAre("ball", "ramp", "post"));
  EXPECT_THAT(evaluation.confusion, ElementsAre(ElementsAre(0, 0, 4, 0), ElementsAre(4, 0, 0, 0)));
  EXPECT_EQ(evaluation.accuracy.value, 1.0);
  const auto json = nlohmann::ordered_json::parse(ToJson(evaluation));
  EXPECT_EQ(json["accuracy"], 1.0);
  EXPECT_EQ(json["accuracy_interval"].size(), 2U);
  EXPECT_EQ(json["truths"][0], "post");
}

TEST_F(EvaluateCloudsTest, AnUnknownClassIsAnErrorUnlessItCountsAsOneOrSeveral) {
  datasets::ViewSet set = WriteObjectViews(folder_ / "test", {"ball"}, 3, 2);
  for (datasets::ObjectView& view : set.items) view.object_class = "orange";
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(EvaluateClouds(model_.get(), set, {})),
      Error,
      AllOf(HasSubstr("the class 'orange' is not one of the model's: ball, ramp, post"),
            HasSubstr("--counts-as orange=CLASS")));
  EXPECT_EQ(EvaluateClouds(model_.get(), set, {}, {{"orange", "ball"}}).num_correct, 3U);
  EXPECT_EQ(EvaluateClouds(model_.get(), set, {}, {{"orange", "ramp"}}).num_correct, 0U);
  EXPECT_EQ(
      EvaluateClouds(model_.get(), set, {}, {{"orange", "ramp"}, {"orange", "ball"}}).num_correct,
      3U);
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(EvaluateClouds(model_.get(), set, {}, {{"orange", "cube"}})),
      Error,
      HasSubstr("the class 'cube'"));
}

TEST_F(EvaluateCloudsTest, TellsEachAnswerAndWhetherNoneWasRight) {
  datasets::ViewSet set = WriteObjectViews(folder_ / "test", {"ball"}, 2, 2);
  const CloudEvaluation known = EvaluateClouds(model_.get(), set, {});
  ASSERT_EQ(known.answers.size(), 2U);
  for (const CloudAnswer& said : known.answers) {
    EXPECT_EQ(said.answer, 0U);
    EXPECT_TRUE(said.has_points);
    EXPECT_TRUE(said.is_right);
    EXPECT_GT(said.margin, 0.0);
  }
  for (datasets::ObjectView& view : set.items) view.object_class = "orange";
  const CloudEvaluation novel =
      EvaluateClouds(model_.get(), set, {}, {{"orange", std::string(kNoneOfThese)}});
  EXPECT_EQ(novel.num_correct, 0U);
  EXPECT_FALSE(novel.answers[0].is_right);
}

TEST_F(EvaluateCloudsTest, AViewWithTooFewPointsIsNoneOfTheClasses) {
  const datasets::ViewSet set = WriteObjectViews(folder_ / "test", {"ball"}, 2, 2);
  datasets::OrganisedCloud empty = datasets::ReadPcd(set.root / set.items[0].cloud);
  for (Eigen::Vector3f& point : empty.points) {
    point.setConstant(std::numeric_limits<float>::quiet_NaN());
  }
  datasets::WritePcd(set.root / set.items[0].cloud, empty);
  const CloudEvaluation evaluation = EvaluateClouds(model_.get(), set, {});
  EXPECT_THAT(evaluation.confusion, ElementsAre(ElementsAre(1, 0, 0, 1)));
  EXPECT_EQ(evaluation.num_rejected, 1U);
  EXPECT_FALSE(evaluation.answers[0].has_points);
  EXPECT_EQ(EvaluateClouds(model_.get(), set, {}, {{"ball", "none of these"}}).num_correct, 1U);
}

TEST_F(EvaluateCloudsTest, OptionsComeFromTheModel) {
  WriteFileAtomically(folder_ / "m", bytes_);
  const datasets::ObjectCloudOptions options = ReadCloudOptions(folder_ / "m");
  EXPECT_EQ(options.frame, features::CloudFrame::kBase);
  EXPECT_EQ(options.outlier_step, 1.5);
}

TEST_F(EvaluateCloudsTest, OtherKindsReadNoClouds) {
  const LoadedModel rows = LoadModel(model_io::Serialise(handcraft::testing::SomeSvmModel()));
  EXPECT_THROWS_MESSAGE(
      CloudClassifier(rows.get()), Error, HasSubstr("it is not of kind object_class"));
}

}  // namespace
}  // namespace handcraft::experiments
