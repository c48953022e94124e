// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/perception/image_io.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;

class TrainGraspPoints : public testing::ImageSetTest {
 protected:
  // Trains into folder_/m with few features and samples.
  [[nodiscard]] Outcome Train(const std::string& options = "",
                              const std::string& features = "edges54") const {
    return RunLine("train grasp-points " + set_.string() + " --out " + model_.string() +
                   " --samples 400 --ridge 1 --features " + features + " " + options);
  }

  // Nothing but the data set is there.
  void ExpectNothingLeft() const { EXPECT_EQ(NumEntries(folder_.path()), 1U); }

  std::filesystem::path model_ = folder_ / "m";
};

TEST_F(TrainGraspPoints, WritesAModelThatTellsItsOrigin) {
  const Outcome outcome = Train();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("400 (200 good, 200 bad)"), HasSubstr(Sha256Hex(ReadFile(model_)))));
  const auto metadata =
      nlohmann::json::parse(RunLine("inspect --json " + model_.string()).out)["metadata"];
  EXPECT_EQ(metadata["hc.training.data_fingerprint"],
            datasets::Fingerprint(datasets::ReadLabelledImageSet(set_).Only("train")));
  EXPECT_EQ(metadata["hc.training.class_counts"], "0: 200, 1: 200");
  EXPECT_EQ(metadata["hc.training.sampling.num_samples"], "400");
  EXPECT_EQ(metadata["hc.training.irls.ridge"], "1");
  EXPECT_EQ(metadata["hc.training.split"], "train");
  EXPECT_THAT(metadata["hc.licence"].get<std::string>(), HasSubstr("CC0-1.0"));
}

// The figures kept in the model are those of `evaluate` on the same split.
TEST_F(TrainGraspPoints, KeepsHeldOutFiguresInTheModel) {
  const Outcome outcome = Train();
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("on 2 images (test)"));
  const auto metadata =
      nlohmann::json::parse(RunLine("inspect --json " + model_.string()).out)["metadata"];
  const auto evaluation = nlohmann::json::parse(
      RunLine("evaluate --json - " + model_.string() + " " + set_.string()).out);
  for (const char* key : {"auc", "accuracy", "log_loss"}) {
    const std::string text = metadata["hc.metrics.held_out." + std::string(key)];
    EXPECT_EQ(std::stod(text), evaluation[key].get<double>()) << key;
  }
  EXPECT_EQ(metadata["hc.metrics.held_out.data_fingerprint"], evaluation["data_fingerprint"]);
  EXPECT_TRUE(metadata.contains("hc.metrics.held_out.auc_low"));
}

// The same kind of model by another method; its confusion matrix stands beside the dissertation's.
TEST_F(TrainGraspPoints, ByLinearDiscriminantAnalysis) {
  const std::string line = "train grasp-points " + set_.string() + " --out " + model_.string() +
                           " --samples 400 --features edges54 --method lda --shrinkage auto";
  const Outcome outcome = RunLine(line);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("linear discriminant analysis"),
                    HasSubstr("percent of held-out pixels"),
                    HasSubstr("54.20"),
                    HasSubstr("34.56")));
  const auto metadata =
      nlohmann::json::parse(RunLine("inspect --json " + model_.string()).out)["metadata"];
  EXPECT_EQ(metadata["hc.kind"], "grasp_point");
  EXPECT_EQ(metadata["hc.training.algorithm"], "lda");
  EXPECT_EQ(metadata["hc.training.lda.shrinkage_rule"], "ledoit_wolf");
  EXPECT_EQ(RunLine("check-model " + model_.string()).code, 0);

  const auto held_out = nlohmann::json::parse(RunLine(line + " --json").out)["held_out"];
  double total = 0.0;
  for (const auto& row : held_out["confusion_percent"]) {
    for (const double percent : row) total += percent;
  }
  EXPECT_NEAR(total, 100.0, 1e-9);
  const auto& weighted = held_out["confusion_percent_at_dissertation_ratio"];
  EXPECT_NEAR(weighted[0][0].get<double>() + weighted[0][1].get<double>(), 62.34, 1e-9);
}

TEST_F(TrainGraspPoints, RefusesOptionsOfTheOtherMethod) {
  const Outcome outcome = Train("--method lda");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--ridge is not read with --method lda"));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, HoldsNothingOutWhenThereIsNothing) {
  for (const char* options : {"--held-out ''", "--split ''", "--split test"}) {
    const auto json = nlohmann::json::parse(Train("--json " + std::string(options)).out);
    EXPECT_TRUE(json["held_out"].is_null()) << options;
  }
  EXPECT_EQ(nlohmann::json::parse(Train("--json").out)["held_out"]["num_images"], 2);
}

TEST_F(TrainGraspPoints, RefusesToMeasureOnWhatTrainingSees) {
  for (const char* options : {"--held-out train", "--split '' --held-out test"}) {
    const Outcome outcome = Train(options);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("training sees these images"));
  }
  EXPECT_THAT(Train("--held-out none").err, HasSubstr("no split 'none'; there are:"));
  ExpectNothingLeft();
}

// A picture that cannot be read costs the figures, not the model.
TEST_F(TrainGraspPoints, WarnsWhenHeldOutImagesCannotBeRead) {
  const auto test = datasets::ReadLabelledImageSet(set_).Only("test");
  WriteFileAtomically(set_ / test.items.front().image, "not a picture");
  const Outcome outcome = Train();
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: no held-out figures: "));
  EXPECT_TRUE(std::filesystem::exists(model_));
}

TEST_F(TrainGraspPoints, TellsMachinesTheSame) {
  const auto json = nlohmann::json::parse(Train("--json").out);
  EXPECT_EQ(json["sha256"], Sha256Hex(ReadFile(model_)));
  EXPECT_EQ(json["num_samples"], 400);
  EXPECT_EQ(json["num_features"], 54);
  EXPECT_EQ(json["termination"], "converged");
  EXPECT_LT(json["deviance"], json["null_deviance"]);
}

TEST_F(TrainGraspPoints, GivesTheSameBytesForAnyNumberOfThreads) {
  ASSERT_EQ(Train("--threads 1 --seed 3").code, 0);
  const auto one_thread = ReadFile(model_);
  ASSERT_EQ(Train("--threads 2 --seed 3").code, 0);
  EXPECT_EQ(ReadFile(model_), one_thread);
  ASSERT_EQ(Train("--threads 2 --seed 4").code, 0);
  EXPECT_NE(ReadFile(model_), one_thread);
}

TEST_F(TrainGraspPoints, SaysThatThereAreFewerSamplesThanAskedFor) {
  const Outcome outcome =
      RunLine("train grasp-points " + set_.string() + " --out " + model_.string() +
              " --samples 1000000 --ridge 1 --features edges54");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("warning: 1000000 samples were asked for; the images give "));
}

TEST_F(TrainGraspPoints, ReplacesAModelOnlyWhenThereIsANewOne) {
  WriteFileAtomically(model_, "old");
  EXPECT_EQ(Train("--max-iterations 1 --warm-start 0").code, 4);
  EXPECT_EQ(ReadTextFile(model_), "old");
}

TEST_F(TrainGraspPoints, NamesAnUnknownFeature) {
  const Outcome outcome = Train("", "all501");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("all501"), HasSubstr("all500")));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, NamesAnUnknownSplitAndThoseThereAre) {
  const Outcome outcome = Train("--split tset");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("tset"), HasSubstr("test"), HasSubstr("train")));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, RefusesWrongSamplingOptions) {
  for (const char* options : {"--bad-per-good 0", "--image-share 0", "--hard-negatives 2"}) {
    const Outcome outcome = Train(options);
    EXPECT_EQ(outcome.code, 2) << options;
    EXPECT_THAT(outcome.err, HasSubstr("Try 'handcraft train grasp-points --help'.")) << options;
  }
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, RefusesColourFeaturesOnGrayPictures) {
  std::filesystem::remove_all(set_);
  testing::WriteImageSet(set_, 1);
  const Outcome outcome = Train("", "saxena459");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("p0.png"), HasSubstr("colour")));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, NamesTheMaskThatDoesNotFit) {
  Image mask(10, 10, 1, datasets::kMaskBad);
  mask.At(5, 5) = datasets::kMaskGood;
  perception::WritePng(set_ / "p1_mask.png", mask);
  const Outcome outcome = Train();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("p1_mask.png"));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, NamesTheMaskThatDoesNotFitThoughItHasOneClass) {
  perception::WritePng(set_ / "p1_mask.png", Image(10, 10, 1, datasets::kMaskBad));
  const Outcome outcome = Train();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("p1_mask.png: the mask is 10x10 pixels, its picture 64x48"));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, WarnsOfAPictureLeftOut) {
  perception::WritePng(set_ / "p1_mask.png", Image(64, 48, 1, datasets::kMaskBad));
  const Outcome outcome = Train("--json");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "handcraft: warning: left out: p1.png, no good pixel\n");
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["num_images"], 3);
}

TEST_F(TrainGraspPoints, CountsTheImagesThatGaveSamples) {
  const Outcome outcome = Train("--image-share 0.5");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 of 4 (train)"));
  const auto json = nlohmann::json::parse(RunLine("inspect --json " + model_.string()).out);
  EXPECT_EQ(json["metadata"]["hc.metrics.train.num_images"], "2");
  EXPECT_EQ(nlohmann::json::parse(Train("--image-share 0.5 --json").out)["num_images"], 2);
}

TEST_F(TrainGraspPoints, RefusesOptionsThatNothingReads) {
  const std::string train = "train grasp-points " + set_.string() + " --out " + model_.string();
  for (const std::string option : {"--bad-per-good", "--hard-negatives"}) {
    std::string line = train + " --samples 0 ";
    const Outcome outcome = RunLine(line.append(option).append(" 1"));
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr(option + " says which pixels to draw"));
  }
  const Outcome outcome = RunLine(train + " --hard-negative-radius 9");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--hard-negative-radius requires --hard-negatives"));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, NeverOverwritesItsDataSet) {
  // p5 is in the other split.
  for (const char* file : {"manifest.csv", "p0.png", "p5_mask.png"}) {
    const auto before = ReadFile(set_ / file);
    const Outcome outcome =
        RunLine("train grasp-points " + set_.string() + " --out " + (set_ / file).string());
    EXPECT_EQ(outcome.code, 2) << file;
    EXPECT_THAT(outcome.err, HasSubstr("would overwrite the input"));
    EXPECT_EQ(ReadFile(set_ / file), before);
  }
}

TEST_F(TrainGraspPoints, SaysThatANumberMustNotBeNegative) {
  for (const char* option : {"--samples -5", "--seed -1"}) {
    const Outcome outcome = Train(option);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("must be 0 or more")) << option;
  }
}

TEST_F(TrainGraspPoints, RefusesMasksOfOneClass) {
  for (int i = 0; i < 6; ++i) {
    perception::WritePng(set_ / ("p" + std::to_string(i) + "_mask.png"), Image(64, 48, 1, 0));
  }
  const Outcome outcome = Train();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("good"));
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, RefusesAMissingOrEmptySet) {
  EXPECT_EQ(RunLine("train grasp-points no/such --out " + model_.string()).code, 3);
  WriteFileAtomically(set_ / "manifest.csv", "");
  EXPECT_EQ(Train().code, 3);
  ExpectNothingLeft();
}

TEST_F(TrainGraspPoints, ChecksThePlaceOfTheModelBeforeTheWork) {
  const Outcome outcome =
      RunLine("train grasp-points no/such --out " + (folder_ / "no/m").string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("cannot write: there is no folder"));
  ExpectNothingLeft();
}

}  // namespace
}  // namespace handcraft::tools
