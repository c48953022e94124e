// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/class_evaluation.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/loaded_model.h"
#include "lib/core/error.h"
#include "tests/lib/runtime/some_models.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// The classes "bottle", "mug", "drill" of tests/lib/runtime/some_models.h.
LoadedModel SomeClasses(double rejection_threshold) {
  model_io::SvmModel model = handcraft::testing::SomeSvm();
  model.rejection_threshold = rejection_threshold;
  return LoadModel(model_io::Serialise(handcraft::testing::SomeSvmModel(model)));
}

TableModel Names() {
  return {.columns = {"length_m", "width_m"},
          .label_column = "object",
          .negative_label = {},
          .positive_label = {},
          .classes = {"bottle", "mug", "drill"}};
}

datasets::Table SomeTable() {
  return {.columns = {"length_m", "width_m"},
          .values = {2.5, 1.5, -1.5, 5.5, -1.5, -5.5, 0.75, -0.5},
          .num_rows = 4,
          .label_column = "object",
          .labels = {"bottle", "mug", "mug", "bottle"}};
}

TEST(ClassifyTable, SaysWhatTheRuntimeSays) {
  const LoadedModel model = SomeClasses(0.5);
  const std::vector<RowClass> classes = ClassifyTable(model.get(), SomeTable());
  ASSERT_EQ(classes.size(), 4U);
  EXPECT_EQ(classes[0].number, 0U);
  EXPECT_EQ(classes[0].margin, 1.0);
  EXPECT_EQ(classes[2].number, 2U);
  EXPECT_TRUE(classes[3].is_rejected);  // its margin is 0.25
  datasets::Table narrow = SomeTable();
  narrow.columns.pop_back();
  EXPECT_THROW(static_cast<void>(ClassifyTable(model.get(), narrow)), std::logic_error);
}

TEST(EvaluateClasses, CountsByHand) {
  const LoadedModel model = SomeClasses(0.5);
  const ClassEvaluation evaluation = EvaluateClasses(model.get(), Names(), SomeTable(), "t.csv");
  EXPECT_EQ(evaluation.num_rows, 4U);
  EXPECT_EQ(evaluation.num_correct, 2U);
  EXPECT_EQ(evaluation.num_rejected, 1U);
  EXPECT_EQ(evaluation.accuracy.value, 0.5);
  EXPECT_THAT(
      evaluation.confusion,
      ElementsAre(ElementsAre(1, 0, 0, 1), ElementsAre(0, 1, 1, 0), ElementsAre(0, 0, 0, 0)));
  const auto json = nlohmann::ordered_json::parse(ToJson(evaluation));
  EXPECT_EQ(json["accuracy"], 0.5);
  EXPECT_EQ(json["accuracy_interval"].size(), 2U);
  EXPECT_EQ(json["confusion"][0][3], 1);
  EXPECT_EQ(json["classes"][2], "drill");
}

TEST(EvaluateClasses, RefusesRowsThatCannotBeCompared) {
  const LoadedModel model = SomeClasses(0.5);
  datasets::Table table = SomeTable();
  table.labels[1] = "cup";
  EXPECT_THROWS_MESSAGE(
      EvaluateClasses(model.get(), Names(), table, "t.csv"),
      Error,
      HasSubstr("label 'cup' of row 2 is not one of the model's: 'bottle', 'mug', 'drill'"));
  table.labels.clear();
  EXPECT_THROWS_MESSAGE(EvaluateClasses(model.get(), Names(), table, "t.csv"),
                        Error,
                        HasSubstr("no label column 'object'"));
  table.num_rows = 0;
  EXPECT_THROWS_MESSAGE(EvaluateClasses(model.get(), Names(), table, "t.csv"),
                        Error,
                        HasSubstr("no rows to evaluate"));
}

}  // namespace
}  // namespace handcraft::experiments
