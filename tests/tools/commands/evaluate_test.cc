// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
#include "lib/core/file.h"
#include "lib/perception/image_io.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;
using ::testing::StartsWith;

class EvaluateTest : public testing::ImageSetTest {
 protected:
  void SetUp() override {
    ImageSetTest::SetUp();
    testing::WriteTable(folder_ / "t.csv");
    testing::TrainGraspPoints(set_, folder_ / "grasp");
    testing::TrainLogistic(folder_ / "t.csv", folder_ / "logistic");
  }

  // Runs `evaluate` on files of the folder; options follow.
  [[nodiscard]] Outcome Evaluate(const std::string& model,
                                 const std::string& data,
                                 const std::string& options = "") const {
    return RunLine("evaluate " + (folder_ / model).string() + " " + (folder_ / data).string() +
                   " --resamples 50 " + options);
  }

  // Gives every pixel of the set the same label.
  void PaintMasks(std::uint8_t value) const {
    for (const auto& item : datasets::ReadLabelledImageSet(folder_ / "set").items) {
      const std::filesystem::path mask = folder_ / "set" / item.mask;
      const Image old = perception::ReadImage(mask);
      perception::WritePng(mask, Image(old.width(), old.height(), 1, value));
    }
  }
};

TEST_F(EvaluateTest, PrintsConfusionMatrixAndIntervals) {
  const Outcome outcome = Evaluate("grasp", "set");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("on 2 images (split test), scored by the runtime"),
                    HasSubstr("predicted good  predicted bad"),
                    HasSubstr("95 % interval over images"),
                    HasSubstr("area under the ROC curve"),
                    ContainsRegex("good pixels called good at 0.5 +[0-9.]+ % +[0-9.]+ % to"),
                    ContainsRegex("bad pixels called bad at 0.9 +[0-9.]+ % +[0-9.]+ % to"),
                    HasSubstr("disc")));
}

TEST_F(EvaluateTest, WritesJsonAndHtmlBesideTheTable) {
  const std::string json_file = (folder_ / "e.json").string();
  const std::string html_file = (folder_ / "e.html").string();
  const Outcome outcome = Evaluate("grasp", "set", "--json " + json_file + " --html " + html_file);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("predicted good"));
  EXPECT_GT(nlohmann::json::parse(ReadTextFile(json_file))["auc"].get<double>(), 0.7);
  EXPECT_THAT(ReadTextFile(html_file), StartsWith("<!DOCTYPE html>"));
}

TEST_F(EvaluateTest, PrintsNothingButJsonWhenAsked) {
  const auto json = nlohmann::json::parse(Evaluate("grasp", "set", "--json").out);
  EXPECT_EQ(json["num_images"], 2);
}

TEST_F(EvaluateTest, GivesTheSameJsonForAnyNumberOfThreads) {
  EXPECT_EQ(Evaluate("grasp", "set", "--json --threads 1").out,
            Evaluate("grasp", "set", "--json --threads 2").out);
}

TEST_F(EvaluateTest, TakesAllImagesWithoutSplit) {
  const Outcome outcome = testing::RunArgs({"evaluate",
                                            (folder_ / "grasp").string(),
                                            (folder_ / "set").string(),
                                            "--split",
                                            "",
                                            "--resamples",
                                            "50"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("on 6 images (all)"));
}

TEST_F(EvaluateTest, MeasuresATable) {
  const Outcome outcome = Evaluate("logistic", "t.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("on 60 rows of"),
                    HasSubstr("predicted yes  predicted no"),
                    HasSubstr("log-loss")));
  const auto json = nlohmann::json::parse(Evaluate("logistic", "t.csv", "--json").out);
  EXPECT_EQ(json["num_rows"], 60);
  EXPECT_GT(json["accuracy"].get<double>(), 0.6);
}

TEST_F(EvaluateTest, HasNoResultWithoutALabelledPixel) {
  PaintMasks(datasets::kMaskDontCare);
  const Outcome outcome = Evaluate("grasp", "set", "--html " + (folder_ / "e.html").string());
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("no pixel of the 2 images is labelled good or bad"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "e.html"));
}

TEST_F(EvaluateTest, LeavesOutWhatOneClassOfPixelsCannotTell) {
  PaintMasks(datasets::kMaskBad);
  const std::string html_file = (folder_ / "e.html").string();
  Outcome outcome = Evaluate("grasp", "set", "--html " + html_file);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err,
              AllOf(StartsWith("handcraft: warning: all "), HasSubstr("labelled 'bad'")));
  EXPECT_THAT(outcome.out,
              AllOf(ContainsRegex("area under the ROC curve +– +–\n"), Not(HasSubstr("nan"))));
  EXPECT_THAT(ReadTextFile(html_file), AllOf(HasSubstr("–"), Not(HasSubstr("nan %"))));
  outcome = Evaluate("grasp", "set", "--json");
  EXPECT_TRUE(nlohmann::json::parse(outcome.out)["auc"].is_null());
}

TEST_F(EvaluateTest, LeavesOutWhatOneLabelOfATableCannotTell) {
  WriteFileAtomically(folder_ / "one.csv", "x1,x2,class\n1,2,yes\n2,1,yes\n");
  Outcome outcome = Evaluate("logistic", "one.csv");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err,
            "handcraft: warning: all 2 rows are labelled 'yes': figures that need 'no' as well, as "
            "the area under the ROC curve, are left out\n");
  EXPECT_THAT(outcome.out,
              AllOf(ContainsRegex("area under the ROC curve +– +–\n"), Not(HasSubstr("nan"))));
  outcome = Evaluate("logistic", "one.csv", "--json");
  EXPECT_TRUE(nlohmann::json::parse(outcome.out)["auc"].is_null());
}

TEST_F(EvaluateTest, RefusesDataOfTheOtherKind) {
  Outcome outcome = Evaluate("grasp", "t.csv");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("a grasp-point model is evaluated on a labelled image set"));
  outcome = Evaluate("logistic", "set");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("set: this model reads tables; a folder was given"));
  outcome = Evaluate("logistic", "t.csv", "--html " + (folder_ / "e.html").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--html"));
}

TEST_F(EvaluateTest, RefusesPictureOptionsForATable) {
  for (const std::string option :
       {"--split", "--top", "--min-probability", "--suppression-radius", "--pixels-per-image"}) {
    const Outcome outcome = Evaluate("logistic", "t.csv", option + " 0.5");
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_THAT(outcome.err, HasSubstr(option));
  }
  EXPECT_THAT(Evaluate("logistic", "t.csv", "--top 3").err,
              HasSubstr("--top is about pictures: it needs a grasp-point model"));
}

TEST_F(EvaluateTest, NeverOverwritesItsInputs) {
  const auto expect_refused = [&](const std::string& model,
                                  const std::string& data,
                                  const std::string& option,
                                  const std::string& output) {
    const auto before = ReadFile(folder_ / output);
    const Outcome outcome = Evaluate(model, data, option + " " + (folder_ / output).string());
    EXPECT_EQ(outcome.code, 2) << output;
    EXPECT_THAT(outcome.err, HasSubstr("would overwrite the input"));
    EXPECT_EQ(ReadFile(folder_ / output), before);
  };
  expect_refused("logistic", "t.csv", "--json", "t.csv");
  expect_refused("logistic", "t.csv", "--json", "logistic");
  expect_refused("grasp", "set", "--json", "set/../set/manifest.csv");
  expect_refused("grasp", "set", "--json", "set/p0.png");
  expect_refused("grasp", "set", "--html", "set/p5_mask.png");
  expect_refused("grasp", "set", "--html", "grasp");
}

TEST_F(EvaluateTest, RefusesOneFileForTwoResults) {
  const std::string file = (folder_ / "e").string();
  const Outcome outcome = Evaluate("grasp", "set", "--json " + file + " --html " + file);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--json and --html name the same file"));
}

TEST_F(EvaluateTest, RefusesATableWithoutTheColumnsOrLabels) {
  WriteFileAtomically(folder_ / "w.csv", "x1,class\n1,yes\n");
  EXPECT_THAT(Evaluate("logistic", "w.csv").err, HasSubstr("columns that are not there: 'x2'"));
  WriteFileAtomically(folder_ / "w.csv", "x1,x2\n1,2\n");
  EXPECT_THAT(Evaluate("logistic", "w.csv").err, HasSubstr("no label column 'class'"));
  WriteFileAtomically(folder_ / "w.csv", "x1,x2,class\n1,2,maybe\n");
  const Outcome outcome = Evaluate("logistic", "w.csv");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("the label 'maybe' of row 1"));
}

TEST_F(EvaluateTest, RefusesWrongOptions) {
  EXPECT_EQ(Evaluate("grasp", "set", "--threshold 1").code, 2);
  EXPECT_EQ(Evaluate("logistic", "t.csv", "--threshold 0").code, 2);
  EXPECT_EQ(Evaluate("grasp", "set", "--split tset").code, 2);
}

TEST_F(EvaluateTest, ChecksItsOutputsBeforeTheWork) {
  const std::size_t before = NumEntries(folder_.path());
  for (const char* option : {"--html ", "--json "}) {
    const Outcome outcome = Evaluate("grasp", "set", option + (folder_ / "no/e").string());
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr("cannot write: there is no folder"));
  }
  EXPECT_EQ(NumEntries(folder_.path()), before);
}

}  // namespace
}  // namespace handcraft::tools
