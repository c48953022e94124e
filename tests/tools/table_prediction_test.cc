// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/table_prediction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/evaluation/loaded_model.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using testing::RunLine;
using ::testing::StartsWith;

const std::string kBreast = HANDCRAFT_SOURCE_DIR "/datasets/samples/tables/breast_w.csv";

// Of a model that a command trains on the table.
TablePrediction Predict(const std::string& trainer) {
  const TemporaryDirectory folder;
  const std::string path = (folder / "m").string();
  EXPECT_EQ(RunLine("train " + trainer + " " + kBreast + " --label class --out " + path).code, 0);
  const experiments::LoadedModel model = experiments::LoadModel(path);
  const experiments::TableModel names = experiments::ReadTableModel(path);
  return PredictTable(model.get(), names, experiments::ReadTableFor(names, kBreast));
}

TEST(PredictTable, GivesProbabilitiesOfALogisticModel) {
  const TablePrediction prediction = Predict("logistic");
  EXPECT_EQ(prediction.json["probabilities"].size(), 683U);
  EXPECT_THAT(prediction.csv, StartsWith("probability"));
}

TEST(PredictTable, GivesClassesOfASupportVectorMachine) {
  const TablePrediction prediction = Predict("svm");
  EXPECT_EQ(prediction.json["classes"].size(), 683U);
  EXPECT_EQ(prediction.json["margins"].size(), 683U);
  EXPECT_THAT(prediction.csv, StartsWith("class,margin\n"));
}

}  // namespace
}  // namespace handcraft::tools
