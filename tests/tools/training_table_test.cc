// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/training_table.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/model_io/model_writer.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class TrainingTableTest : public ::testing::Test {
 protected:
  TrainingTableTest() {
    std::ofstream(folder_ / "t.csv") << "a,fits,b\n1,yes,2\n3,no,4\n5,yes,6\n";
  }

  [[nodiscard]] TableArguments Arguments(const std::string& out) const {
    return {.table = path_, .label = "fits", .out = out, .name = "mine"};
  }

  const handcraft::testing::TemporaryDirectory folder_;
  const std::string path_ = (folder_ / "t.csv").string();
};

TEST_F(TrainingTableTest, ReadsColumnsAndLabels) {
  const TrainingTable table = ReadTrainingTable(Arguments(""));
  EXPECT_THAT(table.table.columns, ElementsAre("a", "b"));
  EXPECT_THAT(table.labels.values, ElementsAre(1, 0, 1));
  EXPECT_EQ(table.Matrix().num_samples, 3U);
  EXPECT_EQ(table.Matrix().Row(2)[1], 6.0);
}

TEST_F(TrainingTableTest, RefusesAResultThatCannotBeWritten) {
  EXPECT_THROWS_MESSAGE(
      ReadTrainingTable(Arguments(path_)), Error, HasSubstr("would overwrite the input"));
  EXPECT_THROW(static_cast<void>(ReadTrainingTable(Arguments("/no/such/folder/m"))), Error);
}

TEST_F(TrainingTableTest, NeedsALabelColumnWhereThereAreSeveral) {
  EXPECT_THROWS_MESSAGE(
      ReadLabelledTable({.table = path_}), Error, HasSubstr("--label is required"));
  std::ofstream(folder_ / "t.libsvm") << "1 1:2\n2 1:3\n";
  EXPECT_EQ(ReadLabelledTable({.table = (folder_ / "t.libsvm").string()}).num_rows, 2U);
}

TEST_F(TrainingTableTest, NamesTheTableInATrainersError) {
  const TrainingTable table = ReadTrainingTable(Arguments(""));
  EXPECT_EQ(NamingTable(table.path, [] { return 7; }), 7);
  const auto fail = []() -> int { throw Error({.reason = "row 3 is odd"}); };
  EXPECT_THROWS_MESSAGE(
      NamingTable(table.path, fail), Error, AllOf(HasSubstr("t.csv"), HasSubstr("row 3 is odd")));
}

TEST_F(TrainingTableTest, WritesWhatTheModelIsOf) {
  const TrainingTable table = ReadTrainingTable(Arguments(""));
  const model_io::ModelFile file = model_io::Parse(
      TableModelBytes(table, {.weights = {1.0, 2.0}}, {.name = "mine", .algorithm = "lda"}), "m");
  EXPECT_EQ(file.metadata.at("hc.kind"), "logistic");
  EXPECT_EQ(file.metadata.at("hc.name"), "mine");
  EXPECT_EQ(file.metadata.at("hc.labels.1"), "yes");
  EXPECT_EQ(file.metadata.at("hc.training.class_counts"), "0: 1, 1: 2");
  EXPECT_EQ(file.metadata.at("hc.training.data_fingerprint").size(), 64U);
}

}  // namespace
}  // namespace handcraft::tools
