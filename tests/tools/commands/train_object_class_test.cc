// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "lib/core/sha256.h"
#include "lib/model_io/model_writer.h"
#include "tests/datasets/some_object_views.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;
using Json = nlohmann::ordered_json;

class TrainObjectClass : public ::testing::Test {
 protected:
  void SetUp() override {
    handcraft::testing::WriteObjectViews(folder_ / "two", {"ball", "ramp"});
    handcraft::testing::WriteObjectViews(folder_ / "three", {"ball", "ramp", "post"});
  }
  [[nodiscard]] std::string Path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] Outcome Train(const std::string& set, const std::string& rest) const {
    return RunLine("train object-class " + Path(set) + " --grid-size 6 " + rest);
  }
  [[nodiscard]] model_io::ModelFile Parse(const std::string& name) const {
    return model_io::Parse(ReadFile(folder_ / name), name);
  }

  handcraft::testing::TemporaryDirectory folder_;
};

TEST_F(TrainObjectClass, WritesAModelThatIsCheckedAndInspected) {
  const Outcome trained = Train("three", "--folds 3 --out " + Path("m"));
  ASSERT_EQ(trained.code, 0) << trained.err;
  EXPECT_THAT(trained.out,
              AllOf(HasSubstr("post"), HasSubstr("poly kernel"), HasSubstr("of 12 views right")));
  EXPECT_THAT(RunLine("check-model " + Path("m")).out, HasSubstr("is a object_class model"));
  EXPECT_THAT(RunLine("inspect " + Path("m")).out,
              AllOf(HasSubstr("cloud_grid_size"), HasSubstr("hc.training.object_class.kernel")));
}

TEST_F(TrainObjectClass, WritesTheSameModelForOneAndTwoThreads) {
  for (const std::string threads : {"1", "2"}) {
    ASSERT_EQ(Train("three", "--threads " + threads + " --out " + Path(threads)).code, 0);
  }
  EXPECT_EQ(ReadFile(folder_ / "1"), ReadFile(folder_ / "2"));
}

TEST_F(TrainObjectClass, SearchesKernels) {
  const Outcome outcome = Train("three", "--folds 2 --search --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_EQ(json["tried"].size(), 39U);
  EXPECT_EQ(json["num_validated"], 12);
}

// Each tensor of the old model is, byte for byte, the beginning of the new one's.
TEST_F(TrainObjectClass, AddsAClassAndLeavesTheOldPairsAsTheyAre) {
  ASSERT_EQ(Train("two", "--out " + Path("m")).code, 0);
  const std::string old_hash = Sha256Hex(ReadFile(folder_ / "m"));
  const model_io::ModelFile old = Parse("m");
  const Outcome added =
      Train("three", "--add-class post --to " + Path("m") + " --out " + Path("grown"));
  ASSERT_EQ(added.code, 0) << added.err;
  EXPECT_THAT(added.out, HasSubstr("2 machines trained"));
  EXPECT_EQ(Sha256Hex(ReadFile(folder_ / "m")), old_hash);
  const model_io::ModelFile grown = Parse("grown");
  EXPECT_EQ(grown.metadata.at("hc.parent"), old_hash);
  for (const char* name : {"support_classes", "machine_begins", "machine_supports"}) {
    const auto& before = std::get<std::vector<std::int32_t>>(old.tensors.at(name).values);
    const auto& after = std::get<std::vector<std::int32_t>>(grown.tensors.at(name).values);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin())) << name;
  }
  for (const char* name : {"dual_coefficients", "intercepts"}) {
    const auto& before = std::get<std::vector<double>>(old.tensors.at(name).values);
    const auto& after = std::get<std::vector<double>>(grown.tensors.at(name).values);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin())) << name;
  }
  const Outcome evaluated = RunLine("evaluate " + Path("grown") + " " + Path("three"));
  EXPECT_THAT(evaluated.out, HasSubstr("12 of 12 views right"));
  ASSERT_EQ(Train("three", "--add-class post --to " + Path("m")).code, 0);  // replaces it
  EXPECT_NE(Sha256Hex(ReadFile(folder_ / "m")), old_hash);
}

TEST_F(TrainObjectClass, RefusesWhatItCannotTrainOn) {
  ASSERT_EQ(Train("two", "--out " + Path("m")).code, 0);
  const std::size_t num_entries = NumEntries(folder_.path());
  const Outcome known = Train("three", "--add-class ball --to " + Path("m"));
  EXPECT_EQ(known.code, 2);
  EXPECT_THAT(known.err, HasSubstr("knows the class 'ball' already"));
  const Outcome missing = Train("three", "--add-class cup --to " + Path("m"));
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err, HasSubstr("no view is of the class 'cup'; there are: ball, ramp, post"));
  EXPECT_EQ(Train("three", "--add-class post").code, 2);
  EXPECT_EQ(Train("three", "--search --add-class post --to " + Path("m")).code, 2);
  EXPECT_THAT(Train("two", "--split test").err, HasSubstr("no view is in the split 'test'"));
  EXPECT_EQ(Train("two", "--out " + Path("two/views.csv")).code, 2);
  EXPECT_THAT(Train("two", "--moved-copies 1").err, HasSubstr("VIEWPOINT"));
  EXPECT_EQ(NumEntries(folder_.path()), num_entries);
}

}  // namespace
}  // namespace handcraft::tools
