// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/table_evaluation.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lib/core/error.h"
#include "tests/experiments/evaluation/edge_model.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// z = 0.1 + x
testing::ModelOwner MakeModel() {
  return testing::LoadModelFile(model_io::MakeLogisticModel(
      {"x"},
      "kind",
      "no",
      "yes",
      {.weights = {1.0}, .intercept = 0.1, .feature_mean = {}, .feature_scale = {}},
      {}));
}

datasets::Table MakeTable(const std::vector<double>& values, std::vector<std::string> labels) {
  return {.columns = {"x"},
          .values = values,
          .num_rows = values.size(),
          .label_column = "kind",
          .labels = std::move(labels)};
}

// Forty rows from whole-number arithmetic, which the reference script makes too.
datasets::Table ReferenceTable() {
  std::vector<double> values;
  std::vector<std::string> labels;
  for (int i = 0; i < 40; ++i) {
    const int level = (7 * i) % 20 - 10;
    values.push_back(level / 4.0);
    labels.emplace_back((13 * i + 5) % 23 < 11 + level ? "yes" : "no");
  }
  return MakeTable(values, std::move(labels));
}

TEST(EvaluateTable, CountsByHand) {
  const testing::ModelOwner model = MakeModel();
  const auto table = MakeTable({1.0, 2.0, -1.0, 0.5, -2.0}, {"yes", "yes", "yes", "no", "no"});
  const TableEvaluation evaluation = EvaluateTable(model.get(), table, "t.csv");
  EXPECT_EQ(evaluation.num_rows, 5U);
  EXPECT_EQ(evaluation.confusion.true_positive, 2U);
  EXPECT_EQ(evaluation.confusion.false_negative, 1U);
  EXPECT_EQ(evaluation.confusion.false_positive, 1U);
  EXPECT_EQ(evaluation.confusion.true_negative, 1U);
  EXPECT_DOUBLE_EQ(evaluation.accuracy.value, 0.6);
  EXPECT_DOUBLE_EQ(evaluation.auc.value, 5.0 / 6.0);  // only yes −1 loses, against no 0.5
  EXPECT_EQ(evaluation.negative_label, "no");
  EXPECT_EQ(evaluation.positive_label, "yes");
  EXPECT_EQ(evaluation.label_column, "kind");
}

// Reference: scikit-learn 1.2.1
//   level = [(7*i)%20-10 for i in range(40)]
//   y = [int((13*i+5)%23 < 11+level[i]) for i in range(40)]
//   p = 1/(1+np.exp(-(0.1+np.array(level)/4)))
//   accuracy_score(y, p > 0.5), roc_auc_score(y, p), log_loss(y, p), brier_score_loss(y, p)
// and R 4.2.2: prop.test(29, 40, correct = FALSE)$conf.int
TEST(EvaluateTable, AgreesWithScikitLearnAndR) {
  const testing::ModelOwner model = MakeModel();
  const TableEvaluation evaluation = EvaluateTable(model.get(), ReferenceTable(), "t.csv");
  EXPECT_DOUBLE_EQ(evaluation.accuracy.value, 0.725);
  EXPECT_NEAR(evaluation.accuracy.low, 0.5716504419378943, 1e-14);
  EXPECT_NEAR(evaluation.accuracy.high, 0.8389198375233267, 1e-14);
  EXPECT_NEAR(evaluation.auc.value, 0.840153452685422, 1e-14);
  EXPECT_NEAR(evaluation.log_loss, 0.5039142150754635, 1e-14);
  EXPECT_NEAR(evaluation.brier, 0.1699691560681105, 1e-14);
  EXPECT_EQ(evaluation.confusion.true_negative, 16U);
  EXPECT_EQ(evaluation.confusion.false_positive, 7U);
  EXPECT_LT(evaluation.auc.low, evaluation.auc.value);
  EXPECT_GT(evaluation.auc.high, evaluation.auc.value);
}

TEST(EvaluateTable, TakesTheThresholdAndDoesNotDependOnThreads) {
  const testing::ModelOwner model = MakeModel();
  const datasets::Table table = ReferenceTable();
  const TableEvaluation strict = EvaluateTable(model.get(), table, "t.csv", {.threshold = 0.99});
  EXPECT_EQ(strict.confusion.true_positive + strict.confusion.false_positive, 0U);
  EXPECT_EQ(ToJson(EvaluateTable(model.get(), table, "t.csv", {.num_threads = 1})),
            ToJson(EvaluateTable(model.get(), table, "t.csv", {.num_threads = 3})));
}

TEST(EvaluateTable, OneClassAloneHasAnAccuracyAndNoAuc) {
  const testing::ModelOwner model = MakeModel();
  const auto table = MakeTable({1.0, -1.0}, {"yes", "yes"});
  const TableEvaluation evaluation = EvaluateTable(model.get(), table, "t.csv");
  EXPECT_DOUBLE_EQ(evaluation.accuracy.value, 0.5);
  EXPECT_TRUE(std::isnan(evaluation.auc.value));
  EXPECT_TRUE(evaluation.roc.empty());
  EXPECT_TRUE(nlohmann::json::parse(ToJson(evaluation))["auc"].is_null());
}

TEST(EvaluateTable, RefusesWhatItCannotEvaluateAndSaysWhy) {
  const testing::ModelOwner model = MakeModel();
  EXPECT_THROWS_MESSAGE(EvaluateTable(model.get(), MakeTable({}, {}), "t.csv"),
                        Error,
                        AllOf(HasSubstr("t.csv"), HasSubstr("no rows")));
  EXPECT_THROWS_MESSAGE(EvaluateTable(model.get(), MakeTable({1.0}, {}), "t.csv"),
                        Error,
                        HasSubstr("no label column 'kind'"));
  EXPECT_THROWS_MESSAGE(EvaluateTable(model.get(), MakeTable({1.0}, {"maybe"}), "t.csv"),
                        Error,
                        AllOf(HasSubstr("'maybe'"), HasSubstr("row 1")));
  datasets::Table wide = MakeTable({1.0}, {"yes"});
  wide.columns = {"x", "y"};
  EXPECT_THROWS_MESSAGE(
      EvaluateTable(model.get(), wide, "t.csv"), std::logic_error, HasSubstr("2, 1"));
  const testing::ModelOwner edges = testing::MakeEdgeModel();
  EXPECT_THROWS_MESSAGE(EvaluateTable(edges.get(), MakeTable({1.0}, {"yes"}), "t.csv"),
                        Error,
                        HasSubstr("no logistic model"));
}

TEST(TableEvaluationOptions, NameTheFieldTheValueAndTheRule) {
  EXPECT_THROWS_MESSAGE((TableEvaluationOptions{.threshold = 0.0}.Validate()),
                        Error,
                        HasSubstr("TableEvaluationOptions.threshold is 0; it must be in (0, 1)"));
  EXPECT_THROWS_MESSAGE((TableEvaluationOptions{.bootstrap_resamples = 0}.Validate()),
                        Error,
                        HasSubstr("bootstrap_resamples is 0"));
  EXPECT_THROWS_MESSAGE(
      (TableEvaluationOptions{.num_threads = 0}.Validate()), Error, HasSubstr("num_threads is 0"));
}

TEST(TableEvaluationJson, HasTheDocumentedKeys) {
  const testing::ModelOwner model = MakeModel();
  const auto json =
      nlohmann::ordered_json::parse(ToJson(EvaluateTable(model.get(), ReferenceTable(), "t.csv")));
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  EXPECT_THAT(keys,
              ElementsAre("kind",
                          "options",
                          "num_rows",
                          "label_column",
                          "negative_label",
                          "positive_label",
                          "accuracy",
                          "accuracy_interval",
                          "auc",
                          "auc_interval",
                          "log_loss",
                          "brier",
                          "confusion",
                          "roc"));
  EXPECT_EQ(json["accuracy"], 0.725);
}

}  // namespace
}  // namespace handcraft::experiments
