// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/cell_training.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/error.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

class TrainCellTest : public ::testing::Test {
 protected:
  TrainCellTest() {
    testing::WriteRoughSet(folder_.path());
    sets_ = {datasets::ReadLabelledImageSet(folder_.path())};
    settings_.features = "filters=laplacian+edge_0,window=1,energy=log";
    settings_.samples = 400;
    settings_.ridge = 0.5;
  }
  [[nodiscard]] CellTraining Train(int num_threads = 1, std::uint64_t seed = 1) const {
    return TrainCell(sets_, settings_, StudySplit::kInstance, seed, num_threads);
  }

  testing::TemporaryDirectory folder_;
  std::vector<datasets::LabelledImageSet> sets_;
  CellSettings settings_;
};

TEST_F(TrainCellTest, MakesAModelThatTheRuntimeTakes) {
  const CellTraining training = Train();
  EXPECT_EQ(training.num_images, 8U);
  EXPECT_EQ(training.num_samples, 400U);
  EXPECT_EQ(training.num_features, 2U);
  EXPECT_EQ(training.termination, "converged");
  EXPECT_LT(training.log_loss, std::numbers::ln2);  // of saying one half
  const LoadedModel model = LoadModel(training.model);
  EXPECT_EQ(hc_model_num_features(model.get()), 2U);
  EXPECT_EQ(MetadataOf(model.get(), "hc.training.irls.ridge"), "0.5");
  EXPECT_EQ(MetadataOf(model.get(), "hc.training.data_fingerprint"),
            datasets::Fingerprint(sets_[0]));
}

TEST_F(TrainCellTest, GivesTheSameModelForAnyNumberOfThreads) {
  const std::vector<std::uint8_t> model = Train(1).model;
  EXPECT_EQ(Train(3).model, model);
  EXPECT_NE(Train(1, 2).model, model);
}

TEST_F(TrainCellTest, TakesAShareOfTheManifestsImages) {
  settings_.training_share = 0.5;
  EXPECT_EQ(Train().num_images, 8U);
  EXPECT_EQ(TrainCell(sets_, settings_, StudySplit::kManifest, 1, 1).num_images, 4U);
}

TEST_F(TrainCellTest, TakesAsManyPixelsOfEachSet) {
  const CellTraining alone = Train();
  testing::WriteRoughSet(folder_ / "other", 2);
  sets_.push_back(datasets::ReadLabelledImageSet(folder_ / "other"));
  const CellTraining both = Train();
  EXPECT_EQ(both.num_samples, 400U);
  EXPECT_EQ(both.num_images, 16U);
  EXPECT_NE(both.model, alone.model);
  EXPECT_EQ(MetadataOf(LoadModel(both.model).get(), "hc.training.data_fingerprint"),
            datasets::Fingerprint(sets_[0]) + "+" + datasets::Fingerprint(sets_[1]));
}

TEST_F(TrainCellTest, TrainsByDiscriminantAnalysis) {
  settings_.classifier = Classifier::kLda;
  const CellTraining training = Train();
  EXPECT_EQ(training.termination, "solved");
  EXPECT_EQ(MetadataOf(LoadModel(training.model).get(), "hc.training.algorithm"), "lda");
  EXPECT_LT(training.log_loss, std::numbers::ln2);
  settings_.features = "edges54,energy=log";
  settings_.samples = 4;
  EXPECT_THROWS_MESSAGE(Train(), Error, ::testing::HasSubstr("set shrinkage = \"auto\""));
  settings_.shrinkage_rule = lda::ShrinkageRule::kLedoitWolf;
  settings_.prior = 0.25;
  const CellTraining shrunk = Train();
  EXPECT_EQ(shrunk.termination, "solved");
  const LoadedModel model = LoadModel(shrunk.model);
  EXPECT_EQ(MetadataOf(model.get(), "hc.training.lda.shrinkage_rule"), "ledoit_wolf");
  EXPECT_EQ(MetadataOf(model.get(), "hc.training.lda.positive_prior"), "0.25");
}

TEST_F(TrainCellTest, TellsOfAnEndWithoutAnOptimum) {
  settings_.ridge = 0.0;
  settings_.samples = 4;
  settings_.features = "edges54,energy=log";
  EXPECT_NE(Train().termination, "converged");
}

TEST_F(TrainCellTest, PassesOnWhatIsWrongWithThePictures) {
  settings_.features = "saxena459";
  EXPECT_THROWS_MESSAGE(Train(), Error, ::testing::HasSubstr("p0.png"));
}

}  // namespace
}  // namespace handcraft::experiments
