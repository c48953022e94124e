// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "lib/model_io/model_writer.h"
#include "lib/model_io/svm_models.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;
using Json = nlohmann::ordered_json;

const std::string kReferences = HANDCRAFT_SOURCE_DIR "/tests/data/trainers/svm_classes";
const std::string kBreast = HANDCRAFT_SOURCE_DIR "/datasets/samples/tables/breast_w.csv";

// The labels that svm-predict 3.24 wrote (tests/data/trainers/make_svm_references.py).
std::vector<std::string> LibsvmLabels(const std::string& kernel) {
  std::istringstream file(ReadTextFile(kReferences + "_" + kernel + ".labels"));
  std::vector<std::string> labels;
  for (std::string label; file >> label;) labels.push_back(label);
  return labels;
}

void ExpectLibsvmsLabels(const std::string& kernel, const std::string& options) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m.safetensors").string();
  const std::string table = kReferences + ".libsvm";
  const Outcome trained =
      RunLine("train svm " + table + " --kernel " + kernel + " " + options + " --out " + model);
  ASSERT_EQ(trained.code, 0) << trained.err;
  const Outcome predicted = RunLine("predict " + model + " " + table + " --json");
  ASSERT_EQ(predicted.code, 0) << predicted.err;
  const Json json = Json::parse(predicted.out);
  EXPECT_EQ(json["predictions"][0]["classes"].get<std::vector<std::string>>(),
            LibsvmLabels(kernel));
}

TEST(TrainSvm, PredictsLibsvmsLabels) {
  ExpectLibsvmsLabels("linear", "--C 0.5");
  ExpectLibsvmsLabels("poly", "--degree 3 --gamma 0.25 --coef0 1 --C 1");
  ExpectLibsvmsLabels("rbf", "--gamma 0.4 --C 2");
}

TEST(TrainSvm, GammaIsOneOverTheNumberOfFeatures) {
  const Outcome outcome = RunLine("train svm " + kReferences + ".libsvm --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["gamma"], 0.25);
  EXPECT_EQ(json["kernel"], "poly");
  EXPECT_EQ(json["num_machines"], 6);
  EXPECT_EQ(json["classes"], (std::vector<std::string>{"7", "-2", "3", "11"}));
  EXPECT_EQ(json["termination"], "converged");
}

TEST(TrainSvm, WritesAModelThatIsCheckedEvaluatedAndPredictedWith) {
  const TemporaryDirectory folder;
  const std::string model = (folder / "m.safetensors").string();
  const Outcome trained =
      RunLine("train svm " + kBreast + " --label class --kernel rbf --standardize --out " + model);
  ASSERT_EQ(trained.code, 0) << trained.err;
  EXPECT_THAT(trained.out, AllOf(HasSubstr("benign"), HasSubstr("support vectors; converged")));
  EXPECT_THAT(RunLine("check-model " + model).out, HasSubstr("is a svm model"));
  EXPECT_THAT(RunLine("inspect " + model).out,
              AllOf(HasSubstr("dual_coefficients"), HasSubstr("hc.training.svm.kernel")));
  const Outcome evaluated = RunLine("evaluate " + model + " " + kBreast);
  ASSERT_EQ(evaluated.code, 0) << evaluated.err;
  EXPECT_THAT(evaluated.out, AllOf(HasSubstr("accuracy"), HasSubstr("predicted malignant")));
  const Json json = Json::parse(RunLine("evaluate " + model + " " + kBreast + " --json").out);
  EXPECT_GT(json["accuracy"].get<double>(), 0.95);
  const std::string out = (folder / "p").string();
  ASSERT_EQ(RunLine("predict " + model + " " + kBreast + " --out " + out).code, 0);
  EXPECT_THAT(ReadTextFile(folder / "p" / "breast_w.classes.csv"),
              HasSubstr("class,margin\nbenign,"));
}

TEST(TrainSvm, WritesTheSameModelForOneAndTwoThreads) {
  const TemporaryDirectory folder;
  for (const std::string threads : {"1", "2"}) {
    std::string line = "train svm " + kReferences;
    line.append(".libsvm --threads ").append(threads).append(" --out ");
    ASSERT_EQ(RunLine(line + (folder / threads).string()).code, 0);
  }
  EXPECT_EQ(ReadFile(folder / "1"), ReadFile(folder / "2"));
}

TEST(TrainSvm, SetsTheThresholdOfNoneOfTheseByHeldOutAndNovelRows) {
  const TemporaryDirectory folder;
  // Two tight classes; novel rows lie between them.
  std::string known = "x,y,label\n";
  std::string novel = "y,x\n";
  for (int i = 0; i < 12; ++i) {
    const std::string off = std::to_string(0.01 * i);
    known.append("0,").append(off).append(",a\n10,").append(off).append(",b\n");
    novel.append(off).append(",").append(std::to_string(4.5 + 0.1 * i)).append("\n");
  }
  WriteFileAtomically(folder / "known.csv", known);
  WriteFileAtomically(folder / "novel.csv", novel);
  const std::string model = (folder / "m").string();
  const std::string line = "train svm " + (folder / "known.csv").string() +
                           " --label label --kernel linear --novel " +
                           (folder / "novel.csv").string();
  EXPECT_THAT(RunLine(line).err, HasSubstr("--novel needs --folds"));
  const Outcome outcome = RunLine(line + " --folds 4 --json --out " + model);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["held_out_accuracy"], 1.0);
  EXPECT_EQ(json["false_rejection"], 0.0);
  EXPECT_EQ(json["false_acceptance"], 0.0);
  const Outcome predicted = RunLine("predict " + model + " " + (folder / "novel.csv").string());
  EXPECT_THAT(predicted.out, HasSubstr("class,margin\n,"));
  EXPECT_THAT(predicted.out, Not(HasSubstr("a,")));
  EXPECT_THAT(RunLine(line + " --folds 4").out, HasSubstr("None of these below a margin of"));
  EXPECT_THAT(RunLine(line + " --folds 13").err, HasSubstr("must be from 2 to 12"));
}

TEST(TrainSvm, SearchesByFolds) {
  const std::string line =
      "train svm " + kReferences + ".libsvm --search kernel=linear,rbf C=0.1,10";
  const Outcome outcome = RunLine(line + " --folds 5 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["num_tried"], 4);
  // No combination alone is better.
  for (const char* alone : {"linear --C 0.1", "linear --C 10", "rbf --C 0.1", "rbf --C 10"}) {
    const Outcome one =
        RunLine("train svm " + kReferences + ".libsvm --folds 5 --json --kernel " + alone);
    EXPECT_LE(Json::parse(one.out)["held_out_accuracy"], json["held_out_accuracy"]) << alone;
  }
  EXPECT_EQ(RunLine(line).code, 2);
  EXPECT_THAT(RunLine(line + " --folds 5").out, HasSubstr("Best of 4 combinations"));
}

TEST(TrainSvm, AddsAClassAndLeavesTheOthersAsTheyAre) {
  const TemporaryDirectory folder;
  std::string old_rows = "x,y,object\n";
  std::string new_rows;
  for (int i = 0; i < 9; ++i) {
    const std::string off = std::to_string(0.1 * i);
    old_rows.append("0,").append(off).append(",mug\n1,").append(off).append(",can\n");
    old_rows.append(off).append(",2,box\n");
    new_rows.append(off).append(",-1,cup\n");
  }
  WriteFileAtomically(folder / "old.csv", old_rows);
  WriteFileAtomically(folder / "all.csv", old_rows + new_rows);
  const std::string old_model = (folder / "old").string();
  const std::string model = (folder / "new").string();
  const std::string all = (folder / "all.csv").string();
  ASSERT_EQ(RunLine("train svm " + (folder / "old.csv").string() +
                    " --label object --kernel rbf --out " + old_model)
                .code,
            0);
  const std::string line = "train svm " + all + " --add-class cup --to " + old_model;
  const Outcome outcome = RunLine(line + " --json --out " + model);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["num_machines"], 3);
  EXPECT_EQ(json["kernel"], "rbf");
  EXPECT_EQ(json["classes"], Json::array({"mug", "can", "box", "cup"}));
  const auto read = [](const std::string& path) {
    return model_io::ReadSvmModel(model_io::Parse(ReadFile(path), path));
  };
  const model_io::SvmModel before = read(old_model);
  const model_io::SvmModel after = read(model);
  ASSERT_EQ(after.NumMachines(), 6U);
  EXPECT_TRUE(std::equal(before.dual_coefficients.begin(),
                         before.dual_coefficients.end(),
                         after.dual_coefficients.begin()));
  EXPECT_TRUE(
      std::equal(before.intercepts.begin(), before.intercepts.end(), after.intercepts.begin()));
  EXPECT_EQ(Json::parse(RunLine("evaluate " + model + " " + all + " --json").out)["accuracy"], 1.0);
  EXPECT_THAT(RunLine("inspect " + model).out, HasSubstr("hc.parent"));
  EXPECT_EQ(RunLine(line + " --out " + old_model).code, 2);
  EXPECT_THAT(
      RunLine("train svm " + (folder / "old.csv").string() + " --add-class cup --to " + old_model)
          .err,
      HasSubstr("no samples of the class 'cup'"));
}

TEST(TrainSvm, RefusesWhatItCannotTrainOn) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "one.csv", "x,y\n1,a\n2,a\n");
  WriteFileAtomically(folder / "two.csv", "x,y\n1,a\n2,b\n");
  const std::string line = "train svm " + folder.path().string();
  EXPECT_THAT(RunLine(line + "/one.csv --label y").err, HasSubstr("holds 1 labels: 'a'"));
  const Outcome without = RunLine(line + "/two.csv");
  EXPECT_EQ(without.code, 2);
  EXPECT_THAT(without.err, HasSubstr("--label is required"));
  EXPECT_EQ(RunLine(line + "/two.csv --label y --C -1").code, 2);
  const Outcome wrong = RunLine(line + "/two.csv --label z --out " + (folder / "m").string());
  EXPECT_EQ(wrong.code, 2);
  EXPECT_EQ(NumEntries(folder.path()), 2U);
}

}  // namespace
}  // namespace handcraft::tools
