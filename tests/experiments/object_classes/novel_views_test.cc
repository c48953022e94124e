// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/object_classes/novel_views.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/evaluation/cloud_evaluation.h"
#include "experiments/evaluation/loaded_model.h"
#include "lib/core/error.h"
#include "lib/model_io/model_writer.h"
#include "tests/datasets/some_object_views.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::TemporaryDirectory;
using handcraft::testing::WriteObjectViews;
using ::testing::AllOf;
using ::testing::HasSubstr;

class NovelViews : public ::testing::Test {
 protected:
  NovelViews() {
    options_.descriptor.grid_size = 6;
    options_.num_folds = 4;
  }

  [[nodiscard]] LoadedModel Load(const ObjectClassTraining& training) const {
    const datasets::MaskedCloud example = datasets::ReadObjectCloud(known_, 0);
    return LoadModel(
        model_io::Serialise(model_io::MakeObjectClassModel(training.model, example.View(), {})));
  }

  TemporaryDirectory folder_;
  datasets::ViewSet known_ = WriteObjectViews(folder_ / "known", {"ball", "post"}, 8);
  datasets::ViewSet novel_ = WriteObjectViews(folder_ / "novel", {"ramp"}, 8);
  ObjectClassOptions options_;
};

// What the calibration counts is what the robot's runtime says of the novel views.
TEST_F(NovelViews, AreRejectedByTheRuntimeAsOftenAsCounted) {
  ObjectClassTraining training = TrainObjectClasses(known_, options_);
  EXPECT_FALSE(training.model.svm.rejection_threshold.has_value());
  const svm::Calibration calibration = RejectNovelViews(novel_, 1.0, 1, training);
  ASSERT_TRUE(training.model.svm.rejection_threshold.has_value());
  EXPECT_EQ(*training.model.svm.rejection_threshold, calibration.chosen.threshold);
  EXPECT_EQ(calibration.chosen.num_known, 16U);
  EXPECT_EQ(calibration.chosen.num_novel, 8U);
  EXPECT_GT(calibration.chosen.num_novel_rejected, 0U);
  const LoadedModel model = Load(training);
  EXPECT_EQ(RejectionThreshold(model.get()), calibration.chosen.threshold);
  const CloudEvaluation said =
      EvaluateClouds(model.get(), novel_, {}, {{"ramp", std::string(kNoneOfThese)}});
  EXPECT_EQ(said.num_correct, calibration.chosen.num_novel_rejected);
  EXPECT_EQ(said.num_rejected, calibration.chosen.num_novel_rejected);
}

// Margins of views that were trained on are larger: they would set the threshold too high.
TEST_F(NovelViews, AreToldFromViewsThatWereHeldOut) {
  const ObjectClassTraining training = TrainObjectClasses(known_, options_);
  ASSERT_EQ(training.margins.size(), 16U);
  const LoadedModel model = Load(training);
  const CloudEvaluation seen = EvaluateClouds(model.get(), known_, {});
  double held_out = 0.0;
  double trained_on = 0.0;
  for (std::size_t i = 0; i < 16; ++i) {
    held_out += training.margins[i];
    trained_on += seen.answers[i].margin;
  }
  EXPECT_LT(held_out, trained_on);
}

TEST_F(NovelViews, LoseNoMoreKnownViewsThanAllowed) {
  ObjectClassTraining training = TrainObjectClasses(known_, options_);
  for (const double limit : {0.0, 0.1, 1.0}) {
    const svm::Rejection chosen = RejectNovelViews(novel_, limit, 1, training).chosen;
    EXPECT_LE(chosen.FalseRejection(), limit);
  }
}

TEST_F(NovelViews, NeedViewsThatWereHeldOut) {
  options_.num_folds = 0;
  ObjectClassTraining training = TrainObjectClasses(known_, options_);
  EXPECT_THROWS_MESSAGE(RejectNovelViews(novel_, 1.0, 1, training),
                        Error,
                        AllOf(HasSubstr("held out, and there are none"), HasSubstr("--folds")));
}

TEST_F(NovelViews, OfAModelThatAClassIsAddedTo) {
  const datasets::ViewSet three = WriteObjectViews(folder_ / "three", {"ball", "post", "box"}, 8);
  const ObjectClassTraining old = TrainObjectClasses(known_, options_);
  model_io::ObjectClassModel parent = old.model;
  parent.svm.rejection_threshold = 0.5;
  // Views of all classes: the threshold can be set anew, and no old pair is touched.
  ObjectClassTraining grown = AddObjectClass(parent, three, "box", options_);
  EXPECT_FALSE(grown.model.svm.rejection_threshold.has_value());
  ASSERT_EQ(grown.margins.size(), 24U);
  const svm::Calibration calibration = RejectNovelViews(novel_, 1.0, 1, grown);
  EXPECT_EQ(grown.model.svm.rejection_threshold, calibration.chosen.threshold);
  EXPECT_TRUE(std::equal(parent.svm.dual_coefficients.begin(),
                         parent.svm.dual_coefficients.end(),
                         grown.model.svm.dual_coefficients.begin()));
  // Held-out margins are those of training all three at once with the old kernel.
  options_.svm.gamma = old.svm.gamma;
  const ObjectClassTraining all = TrainObjectClasses(three, options_);
  for (std::size_t i = 0; i < 24; ++i) EXPECT_NEAR(grown.margins[i], all.margins[i], 1e-9);
  // The new class alone: support vectors stand for the old ones, and were trained on.
  const datasets::ViewSet box = WriteObjectViews(folder_ / "box", {"box"}, 8);
  ObjectClassTraining lone = AddObjectClass(parent, box, "box", options_);
  EXPECT_FALSE(lone.model.svm.rejection_threshold.has_value());
  EXPECT_THROWS_MESSAGE(
      RejectNovelViews(novel_, 1.0, 1, lone), Error, HasSubstr("views of every class"));
}

TEST_F(NovelViews, WithoutAPointAreNamed) {
  datasets::OrganisedCloud cloud = datasets::ReadPcd(novel_.root / novel_.items[3].cloud);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (Eigen::Vector3f& point : cloud.points) point.setConstant(nan);
  datasets::WritePcd(novel_.root / novel_.items[3].cloud, cloud);
  ObjectClassTraining training = TrainObjectClasses(known_, options_);
  EXPECT_THROWS_MESSAGE(
      RejectNovelViews(novel_, 1.0, 1, training), Error, HasSubstr("novel/ramp_3.pcd"));
  EXPECT_FALSE(training.model.svm.rejection_threshold.has_value());
}

TEST_F(NovelViews, AreNotKnownOnes) {
  const std::vector<std::string> classes = {"ball", "post"};
  EXPECT_NO_THROW(RequireNovel(novel_, known_, classes));
  // A set may hold views that are passed over, and a model may know classes without views.
  EXPECT_NO_THROW(RequireNovel(novel_, novel_, classes));
  EXPECT_THROWS_MESSAGE(RequireNovel(novel_, known_, {"ball", "post", "ramp"}),
                        Error,
                        HasSubstr("its class 'ramp' is one to tell"));
  const auto refused = [&](auto change, const std::string& message) {
    datasets::ViewSet novel = novel_;
    change(novel.items[2]);
    EXPECT_THROWS_MESSAGE(
        RequireNovel(novel, known_, classes),
        Error,
        AllOf(HasSubstr("ramp_2.png: this view is not novel"), HasSubstr(message)));
  };
  refused([](auto& view) { view.object_class = "post"; }, "its class 'post' is one to tell");
  refused([](auto& view) { view.instance = "ball_0"; }, "the instance 'ball_0' is trained on");
  refused([](auto& view) { view.cloud = "../known/ball_1.pcd"; }, "its cloud is trained on");
  std::filesystem::create_directory_symlink(folder_ / "known", folder_ / "novel" / "link");
  refused([](auto& view) { view.cloud = "link/ball_1.pcd"; }, "its cloud is trained on");
  std::filesystem::copy_file(folder_ / "known/ball_1.pcd", folder_ / "novel/copy.pcd");
  refused([](auto& view) { view.cloud = "copy.pcd"; }, "its cloud is trained on");
}

}  // namespace
}  // namespace handcraft::experiments
