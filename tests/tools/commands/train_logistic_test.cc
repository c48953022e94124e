// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/npy.h"
#include "lib/core/file.h"
#include "tests/support/matrix_matchers.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::AreClose;
using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunArgs;
using testing::RunLine;

// R 4.2.2:
//   d <- read.csv("datasets/samples/tables/breast_w.csv", stringsAsFactors = TRUE)
//   g <- glm(class ~ ., binomial, d, control = list(epsilon = 1e-14, maxit = 50))
//   options(digits = 17); cbind(coef(g), sqrt(diag(vcov(g)))); deviance(g); g$null.deviance; AIC(g)
TEST(TrainLogistic, AgreesWithR) {
  const Outcome outcome = RunLine("train logistic " HANDCRAFT_SOURCE_DIR
                                  "/datasets/samples/tables/breast_w.csv --label class --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  std::vector<double> coefficients = {json["intercept"]["coefficient"].get<double>()};
  std::vector<double> standard_errors = {json["intercept"]["standard_error"].get<double>()};
  for (const auto& entry : json["coefficients"]) {
    coefficients.push_back(entry["coefficient"].get<double>());
    standard_errors.push_back(entry["standard_error"].get<double>());
    EXPECT_DOUBLE_EQ(entry["z"].get<double>(), coefficients.back() / standard_errors.back());
  }
  const std::vector<double> expected = {-10.1039422450103906215,
                                        0.5350140681948901689,
                                        -0.0062797168758230706,
                                        0.3227064957800523937,
                                        0.3306369153545252737,
                                        0.0966354171207036844,
                                        0.3830245724146527087,
                                        0.4471879200360010520,
                                        0.2130306816154375893,
                                        0.5348356314339127726};
  const std::vector<double> expected_errors = {1.174896096979007876,
                                               0.142018360680287753,
                                               0.209078746126658527,
                                               0.230602377872462294,
                                               0.123451473759011734,
                                               0.156592933886782304,
                                               0.093843737363338148,
                                               0.171383435945596324,
                                               0.112874014170018036,
                                               0.328777284985160845};
  EXPECT_TRUE(AreClose(coefficients, expected, 1e-8));
  EXPECT_TRUE(AreClose(standard_errors, expected_errors, 1e-6));
  EXPECT_NEAR(json["deviance"].get<double>(), 102.88819116201921, 1e-9);
  EXPECT_NEAR(json["null_deviance"].get<double>(), 884.35018891062157, 1e-9);
  EXPECT_NEAR(json["aic"].get<double>(), 122.88819116201921, 1e-9);
  EXPECT_EQ(json["termination"], "converged");
  EXPECT_EQ(json["positive_label"], "malignant");
  EXPECT_EQ(json["num_samples"], 683);
  EXPECT_LT(json["gradient_norm"].get<double>(), 1e-8);
}

TEST(TrainLogistic, RefusesANameForNoModel) {
  const Outcome outcome = RunLine("train logistic t.csv --label class --name mine");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--name requires --out"));
}

TEST(TrainLogistic, PrintsASummary) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  const Outcome outcome =
      RunArgs({"train", "logistic", (folder / "t.csv").string(), "--label", "class"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("x1"), HasSubstr("x2"), HasSubstr("AIC")));
  EXPECT_EQ(NumEntries(folder.path()), 1U);
}

TEST(TrainLogistic, NeverOverwritesItsTable) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  const auto before = ReadFile(folder / "t.csv");
  const Outcome outcome = RunLine("train logistic " + (folder / "t.csv").string() +
                                  " --label class --out " + (folder / "./t.csv").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would overwrite the input"));
  EXPECT_EQ(ReadFile(folder / "t.csv"), before);
}

TEST(TrainLogistic, WritesTheSameModelForOneAndTwoThreads) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  for (const std::string threads : {"1", "2"}) {
    const Outcome outcome = RunArgs({"train",
                                     "logistic",
                                     (folder / "t.csv").string(),
                                     "--label",
                                     "class",
                                     "--threads",
                                     threads,
                                     "--out",
                                     (folder / threads).string()});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
  }
  EXPECT_EQ(ReadFile(folder / "1"), ReadFile(folder / "2"));
}

TEST(TrainLogistic, TakesNpyWithTheLabelByNumber) {
  const TemporaryDirectory folder;
  const std::vector<double> rows = {1, 0, 2, 1, 3, 0, 4, 1, 5, 0, 6, 1};
  datasets::WriteNpy(folder / "t.npy", rows.data(), 6, 2);
  const Outcome outcome =
      RunArgs({"train", "logistic", (folder / "t.npy").string(), "--label", "-1", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["label_column"], "1");
  EXPECT_EQ(json["coefficients"][0]["name"], "0");
}

TEST(TrainLogistic, SaysThatClassesAreSeparatedAndWritesNothing) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "t.csv", "x,y\n1,a\n2,a\n3,b\n4,b\n");
  const Outcome outcome = RunArgs({"train",
                                   "logistic",
                                   (folder / "t.csv").string(),
                                   "--label",
                                   "y",
                                   "--out",
                                   (folder / "m").string()});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("separation"), HasSubstr("--ridge 1")));
  EXPECT_EQ(NumEntries(folder.path()), 1U);
}

TEST(TrainLogistic, WarnsOfRedundantColumnsByName) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "t.csv",
                      "x,twice_x,y\n1,2,a\n2,4,b\n3,6,a\n4,8,b\n5,10,a\n6,12,b\n7,14,b\n8,16,a\n");
  const Outcome outcome =
      RunArgs({"train", "logistic", (folder / "t.csv").string(), "--label", "y"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("warning: rank deficient"), HasSubstr("x")));
}

TEST(TrainLogistic, StopsAtTheIterationLimitWithCode4) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  const Outcome outcome = RunLine("train logistic " + (folder / "t.csv").string() +
                                  " --label class --max-iterations 1 --warm-start 0");
  EXPECT_EQ(outcome.code, 4);
  EXPECT_THAT(outcome.err, HasSubstr("--max-iterations"));
}

struct WrongTable {
  const char* text;
  const char* label;
  int code;
  const char* message;
};

TEST(TrainLogistic, RefusesWrongTables) {
  const std::vector<WrongTable> cases = {
      {"", "y", 3, "empty"},
      {"x,y\n", "y", 3, "no row"},
      {"x,y\n1,a\n2,b\n", "z", 2, "no column 'z'; there are: 'x', 'y'"},
      {"x,y\n1,a\nnan,b\n", "y", 3, "t.csv:3: column 'x': 'nan' is not a finite number"},
      {"x,y\n1,a\nred,b\n", "y", 3, "t.csv:3: column 'x': 'red' where a number is due"},
      {"x,y\n1,a\n2\n", "y", 3, "t.csv:3: "},
      {"x,y\n1,a\n2,a\n", "y", 3, "holds 1 label"},
      {"x,y\n1,a\n2,b\n3,c\n", "y", 3, "holds 3 labels"}};
  for (const WrongTable& wrong : cases) {
    const TemporaryDirectory folder;
    WriteFileAtomically(folder / "t.csv", wrong.text);
    const Outcome outcome = RunArgs({"train",
                                     "logistic",
                                     (folder / "t.csv").string(),
                                     "--label",
                                     wrong.label,
                                     "--out",
                                     (folder / "m").string()});
    EXPECT_EQ(outcome.code, wrong.code) << wrong.text;
    EXPECT_THAT(outcome.err, HasSubstr(wrong.message)) << wrong.text;
    EXPECT_EQ(outcome.out, "") << wrong.text;
    EXPECT_EQ(NumEntries(folder.path()), 1U) << wrong.text;
  }
}

TEST(TrainLogistic, NamesTheFileThatTheTrainerRefuses) {
  const TemporaryDirectory folder;
  WriteFileAtomically(folder / "huge.csv", "x,y\n0,0\n1e300,1\n1,0\n2,1\n");
  const Outcome outcome =
      RunLine("train logistic " + (folder / "huge.csv").string() + " --label y");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("huge.csv: column 0 (counted from 0) has a spread"));
}

TEST(TrainLogistic, RefusesAPlaceItCannotWriteTo) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  const std::string command =
      "train logistic " + (folder / "t.csv").string() + " --label class --out ";
  EXPECT_EQ(RunLine(command + folder.path().string()).code, 3);
  const Outcome outcome = RunLine(command + (folder / "no/m").string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("cannot write: there is no folder"));
  EXPECT_EQ(NumEntries(folder.path()), 1U);
}

}  // namespace
}  // namespace handcraft::tools
