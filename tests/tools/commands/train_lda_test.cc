// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "tests/support/matrix_matchers.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;

const std::string kBreast = HANDCRAFT_SOURCE_DIR "/datasets/samples/tables/breast_w.csv";

// scikit-learn 1.2.1, by tests/data/trainers/make_lda_references.py on the same 683 rows.
TEST(TrainLda, AgreesWithScikitLearn) {
  const Outcome outcome = RunLine("train lda " + kBreast + " --label class --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::ordered_json::parse(outcome.out);
  EXPECT_EQ(json["num_samples"], 683);
  EXPECT_EQ(json["positive_label"], "malignant");
  EXPECT_EQ(json["termination"], "solved");
  EXPECT_NEAR(json["intercept"].get<double>(), -20.878096220081204, 1e-9);
  std::vector<double> weights;
  for (const auto& weight : json["weights"]) weights.push_back(weight.get<double>());
  const std::vector<double> expected = {0.88720383488109844,
                                        0.61113492981023898,
                                        0.43753356511143959,
                                        0.23061336857890563,
                                        0.28186052227893443,
                                        1.2697242545656817,
                                        0.53645611988155562,
                                        0.51837569318491872,
                                        0.027385216868913743};
  EXPECT_TRUE(handcraft::testing::AreClose(weights, expected, 1e-9));
}

TEST(TrainLda, WritesALogisticModelThatIsEvaluatedAndPredictedWith) {
  const TemporaryDirectory folder;
  const std::string table = (folder / "t.csv").string();
  const std::string model = (folder / "m.safetensors").string();
  testing::WriteTable(table);
  const Outcome trained =
      RunLine("train lda " + table + " --label class --shrinkage auto --out " + model);
  ASSERT_EQ(trained.code, 0) << trained.err;
  EXPECT_THAT(trained.out, AllOf(HasSubstr("x1"), HasSubstr("shrinkage"), HasSubstr("= yes")));
  EXPECT_EQ(RunLine("check-model " + model).code, 0);
  const Outcome evaluated = RunLine("evaluate " + model + " " + table);
  EXPECT_EQ(evaluated.code, 0) << evaluated.err;
  EXPECT_THAT(evaluated.out, HasSubstr("accuracy"));
  const Outcome inspected = RunLine("inspect " + model);
  EXPECT_THAT(inspected.out, AllOf(HasSubstr("ledoit_wolf"), HasSubstr("hc.training.algorithm")));
  EXPECT_EQ(RunLine("predict " + model + " " + table + " --out " + (folder / "p").string()).code,
            0);
}

TEST(TrainLda, WritesTheSameModelForOneAndTwoThreads) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(RunLine("train lda " + (folder / "t.csv").string() + " --label class --threads " +
                      threads + " --out " + (folder / threads).string())
                  .code,
              0);
  }
  EXPECT_EQ(ReadFile(folder / "1"), ReadFile(folder / "2"));
}

TEST(TrainLda, AsksForShrinkageWhenTheCovarianceIsSingular) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "t.csv", "x,twice_x,y\n1,2,a\n2,4,b\n3,6,a\n4,8,b\n5,10,b\n");
  const std::string line =
      "train lda " + (folder / "t.csv").string() + " --label y --out " + (folder / "m").string();
  const Outcome outcome = RunLine(line);
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("is singular"), HasSubstr("give --shrinkage auto")));
  EXPECT_EQ(NumEntries(folder.path()), 1U);
  EXPECT_EQ(RunLine(line + " --shrinkage auto").code, 0);
}

TEST(TrainLda, RefusesOneClassATextAndAWrongShare) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "one.csv", "x,y\n1,a\n2,a\n");
  WriteFileAtomically(folder / "nan.csv", "x,y\n1,a\nnan,b\n2,b\n");
  const std::string line = "train lda " + folder.path().string();
  EXPECT_THAT(RunLine(line + "/one.csv --label y").err, HasSubstr("holds 1 label"));
  const Outcome outcome = RunLine(line + "/nan.csv --label y");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("nan.csv:3: column 'x': 'nan' is not a finite number"));
  EXPECT_EQ(RunLine(line + "/nan.csv --label y --shrinkage 3").code, 2);
}

}  // namespace
}  // namespace handcraft::tools
