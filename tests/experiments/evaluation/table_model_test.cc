// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/table_model.h"

#include <cmath>
#include <memory>

#include "datasets/formats/npy.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "lib/features/feature_spec.h"
#include "lib/model_io/linear_models.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// z = 0.5 + 1 · b − 2 · a, for columns "b", "a" in this order; label column "kind": "no", "yes".
class TableModelTest : public ::testing::Test {
 protected:
  void SetUp() override {
    WriteFileAtomically(
        path_,
        model_io::Serialise(model_io::MakeLogisticModel(
            {"b", "a"}, "kind", "no", "yes", {.weights = {1.0, -2.0}, .intercept = 0.5}, {})));
    hc_model* model = nullptr;
    ASSERT_EQ(hc_model_load_file(path_.c_str(), &model, nullptr), HC_OK);
    model_.reset(model);
    names_ = ReadTableModel(path_);
  }

  [[nodiscard]] datasets::Table Read(const std::string& csv) const {
    WriteFileAtomically(table_, csv);
    return ReadTableFor(names_, table_);
  }

  TemporaryDirectory folder_;
  std::filesystem::path path_ = folder_ / "m";
  std::filesystem::path table_ = folder_ / "t.csv";
  std::unique_ptr<hc_model, decltype(&hc_model_free)> model_{nullptr, hc_model_free};
  TableModel names_;
};

TEST_F(TableModelTest, KnowsItsColumnsAndLabels) {
  EXPECT_THAT(names_.columns, ElementsAre("b", "a"));
  EXPECT_EQ(names_.label_column, "kind");
  EXPECT_EQ(names_.negative_label, "no");
  EXPECT_EQ(names_.positive_label, "yes");
}

TEST_F(TableModelTest, TakesItsColumnsWhereverTheyStand) {
  const datasets::Table table = Read("a,other,kind,b\n1,9,yes,3\n2,9,no,4\n");
  EXPECT_THAT(table.columns, ElementsAre("b", "a"));
  EXPECT_THAT(table.values, ElementsAre(3, 1, 4, 2));
  EXPECT_THAT(table.labels, ElementsAre("yes", "no"));
}

TEST_F(TableModelTest, PassesOverColumnsItDoesNotRead) {
  EXPECT_THAT(Read("id,a,b\nfirst,1,3\n,2,4\n").values, ElementsAre(3, 1, 4, 2));
  EXPECT_THROWS_MESSAGE(Read("id,y\nfirst,x\n"), Error, HasSubstr("not there: 'b', 'a'"));
}

TEST_F(TableModelTest, DoesWithoutLabels) {
  const datasets::Table table = Read("a,b\n1,3\n");
  EXPECT_THAT(table.values, ElementsAre(3, 1));
  EXPECT_THAT(table.labels, IsEmpty());
  EXPECT_THROWS_MESSAGE(
      RequireLabelsOf(names_, table, table_), Error, HasSubstr("no label column 'kind'"));
}

TEST_F(TableModelTest, PredictsWithTheRuntime) {
  const std::vector<double> probabilities = PredictTable(model_.get(), Read("a,b\n0,0\n1,3\n"));
  ASSERT_EQ(probabilities.size(), 2U);
  EXPECT_DOUBLE_EQ(probabilities[0], 1.0 / (1.0 + std::exp(-0.5)));
  EXPECT_DOUBLE_EQ(probabilities[1], 1.0 / (1.0 + std::exp(-1.5)));
}

TEST_F(TableModelTest, TakesAnNpyFileOfItsWidthAsItIs) {
  const std::vector<double> rows = {3, 1, 4, 2};
  datasets::WriteNpy(folder_ / "t.npy", rows.data(), 2, 2);
  EXPECT_THAT(ReadTableFor(names_, folder_ / "t.npy").values, ElementsAre(3, 1, 4, 2));
}

TEST_F(TableModelTest, TakesTheLabelColumnOfAnNpyFileByNumber) {
  const TableModel model{
      .columns = {"1", "2"}, .label_column = "0", .negative_label = "0", .positive_label = "1"};
  const std::vector<double> rows = {1, 3, 4, 0, 5, 6};
  datasets::WriteNpy(folder_ / "t.npy", rows.data(), 2, 3);
  const datasets::Table table = ReadTableFor(model, folder_ / "t.npy");
  EXPECT_THAT(table.values, ElementsAre(3, 4, 5, 6));
  EXPECT_THAT(table.labels, ElementsAre("1", "0"));
}

TEST_F(TableModelTest, SaysThatItReadsTables) {
  EXPECT_THROWS_MESSAGE(ReadTableFor(names_, folder_.path()),
                        Error,
                        HasSubstr("this model reads tables; a folder was given"));
  EXPECT_THROWS_MESSAGE(ReadTableFor(names_, folder_ / "x.PNG"),
                        Error,
                        HasSubstr("this model reads tables; a picture was given"));
}

TEST_F(TableModelTest, NamesMissingColumns) {
  EXPECT_THROWS_MESSAGE(
      Read("x,y\n1,2\n"), Error, AllOf(HasSubstr("t.csv: "), HasSubstr("not there: 'b', 'a'")));
  EXPECT_THROWS_MESSAGE(Read(""), Error, HasSubstr("empty"));
}

TEST_F(TableModelTest, NamesAForeignLabel) {
  const datasets::Table table = Read("a,b,kind\n1,3,no\n1,3,maybe\n");
  EXPECT_THROWS_MESSAGE(RequireLabelsOf(names_, table, table_),
                        Error,
                        HasSubstr("the label 'maybe' of row 2 is not one of the model's: 'no', "
                                  "'yes'"));
  RequireLabelsOf(names_, Read("a,b,kind\n1,3,no\n"), table_);
}

TEST_F(TableModelTest, RefusesAModelOfPictures) {
  const features::FeatureSpec spec = features::ParseFeatureSpec("edges54");
  WriteFileAtomically(path_,
                      model_io::Serialise(model_io::MakeGraspPointModel(
                          spec, {.weights = std::vector<double>(54, 0.0)}, {})));
  EXPECT_THROWS_MESSAGE(
      ReadTableModel(path_), Error, HasSubstr("kind grasp_point, which reads no tables"));
}

}  // namespace
}  // namespace handcraft::experiments
