// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <filesystem>

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
  // The model to add to has the grid.
  [[nodiscard]] Outcome Add(const std::string& set, const std::string& rest) const {
    return RunLine("train object-class " + Path(set) + " --to " + Path("m") + " --add-class " +
                   rest);
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
  const Outcome added = Add("three", "post --out " + Path("grown"));
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
  ASSERT_EQ(Add("three", "post").code, 0);  // replaces it
  EXPECT_NE(Sha256Hex(ReadFile(folder_ / "m")), old_hash);
}

TEST_F(TrainObjectClass, RefusesWhatItCannotTrainOn) {
  ASSERT_EQ(Train("two", "--out " + Path("m")).code, 0);
  const std::size_t num_entries = NumEntries(folder_.path());
  const Outcome known = Add("three", "ball");
  EXPECT_EQ(known.code, 2);
  EXPECT_THAT(known.err, HasSubstr("knows the class 'ball' already"));
  const Outcome missing = Add("three", "cup");
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err, HasSubstr("no view is of the class 'cup'; there are: ball, ramp, post"));
  EXPECT_EQ(Train("three", "--add-class post").code, 2);
  EXPECT_EQ(Add("three", "post --search").code, 2);
  const Outcome grid = Add("three", "post --grid-size 7");
  EXPECT_EQ(grid.code, 2);
  EXPECT_THAT(grid.err, HasSubstr("--grid-size"));
  const Outcome folds = Train("three", "--folds 5000");
  EXPECT_EQ(folds.code, 2);
  EXPECT_THAT(folds.err,
              AllOf(HasSubstr("--folds: 5000 given; it must be at most 4"), HasSubstr("-1")));
  EXPECT_EQ(Train("three", "--folds -1").code, 0);
  EXPECT_THAT(Train("three", "--folds 0 --search").err,
              HasSubstr("the number of folds is 0; it must be at least 2 for a search"));
  EXPECT_THAT(Train("two", "--split test").err, HasSubstr("no view is in the split 'test'"));
  EXPECT_EQ(Train("two", "--out " + Path("two/views.csv")).code, 2);
  EXPECT_THAT(Train("two", "--moved-copies 1").err, HasSubstr("VIEWPOINT"));
  EXPECT_EQ(NumEntries(folder_.path()), num_entries);
}

// From views to a robot's answer: what is novel is found as often as the training said.
TEST_F(TrainObjectClass, NovelViewsSetAThresholdThatAllCommandsHonour) {
  handcraft::testing::WriteObjectViews(folder_ / "known", {"ball", "post"}, 8);
  handcraft::testing::WriteObjectViews(folder_ / "novel", {"ramp"}, 8);
  const std::string novel = " --novel " + Path("novel");
  const Outcome trained = Train("known", "--folds 4 --json --out " + Path("m") + novel);
  ASSERT_EQ(trained.code, 0) << trained.err;
  const Json json = Json::parse(trained.out);
  EXPECT_EQ(json["num_novel"], 8);
  EXPECT_EQ(json["num_held_out"], 16);
  const double threshold = json["rejection_threshold"];
  const double found = 8.0 * (1.0 - json["false_acceptance"].get<double>());
  EXPECT_GT(found, 0.0);

  const std::string as_none = "--counts-as=ramp=none of these";
  const Outcome evaluated =
      testing::RunArgs({"evaluate", Path("m"), Path("novel"), as_none, "--json"});
  ASSERT_EQ(evaluated.code, 0) << evaluated.err;
  const Json counts = Json::parse(evaluated.out);
  EXPECT_EQ(counts["rejection_threshold"], threshold);
  EXPECT_EQ(counts["num_novel"], 8);
  EXPECT_EQ(counts["num_novel_rejected"].get<double>(), found);
  EXPECT_EQ(counts["num_correct"], counts["num_novel_rejected"]);
  EXPECT_THAT(testing::RunArgs({"evaluate", Path("m"), Path("novel"), as_none}).out,
              AllOf(HasSubstr("None of these below a margin of"), HasSubstr("of 8 novel views")));
  EXPECT_EQ(Json::parse(RunLine("check-model --json " + Path("m")).out)["rejection_threshold"],
            threshold);
  EXPECT_THAT(RunLine("check-model " + Path("m")).out, HasSubstr("what has a margin below"));
  EXPECT_THAT(RunLine("inspect " + Path("m")).out,
              AllOf(HasSubstr("rejection_threshold"),
                    HasSubstr("hc.metrics.rejection.false_acceptance"),
                    HasSubstr("hc.training.object_class.novel_fingerprint")));

  const auto predict = [&](int number) {
    const std::string stem = Path("novel/ramp_" + std::to_string(number));
    return RunLine("predict " + Path("m") + " " + stem + ".pcd --json --object-mask " + stem +
                   "_mask.png");
  };
  std::size_t num_rejected = 0;
  for (int i = 0; i < 8; ++i) {
    const Outcome said = predict(i);
    ASSERT_EQ(said.code, 0) << said.err;
    const Json one = Json::parse(said.out)["predictions"][0];
    EXPECT_EQ(one["class"].is_null(), one["margin"].get<double>() < threshold);
    EXPECT_TRUE(one["nearest_class"] == "ball" || one["nearest_class"] == "post");
    num_rejected += one["class"].is_null() ? 1 : 0;
  }
  EXPECT_EQ(static_cast<double>(num_rejected), found);
  // No known view may be lost: fewer novel ones are found, at a lower threshold.
  const Json careful = Json::parse(Train("known", "--folds 4 --json --max-lost 0" + novel).out);
  EXPECT_EQ(careful["false_rejection"], 0.0);
  EXPECT_LE(careful["rejection_threshold"].get<double>(), threshold);
}

TEST_F(TrainObjectClass, AddingAClassDropsTheThresholdOrSetsItAnew) {
  handcraft::testing::WriteObjectViews(folder_ / "known", {"ball", "post"}, 8);
  handcraft::testing::WriteObjectViews(folder_ / "all", {"ball", "post", "box"}, 8);
  handcraft::testing::WriteObjectViews(folder_ / "box", {"box"}, 8);
  handcraft::testing::WriteObjectViews(folder_ / "novel", {"ramp"}, 8);
  const std::string novel = " --novel " + Path("novel");
  ASSERT_EQ(Train("known", "--folds 4 --out " + Path("m") + novel).code, 0);
  const Outcome dropped = Add("all", "box --json --out " + Path("dropped"));
  ASSERT_EQ(dropped.code, 0) << dropped.err;
  EXPECT_THAT(dropped.err, AllOf(HasSubstr("warning"), HasSubstr("is dropped")));
  EXPECT_TRUE(Json::parse(dropped.out)["dropped_threshold"].is_number());
  EXPECT_FALSE(Parse("dropped").tensors.contains("rejection_threshold"));
  const Outcome anew = Add("all", "box --folds 4 --out " + Path("anew") + novel);
  ASSERT_EQ(anew.code, 0) << anew.err;
  EXPECT_EQ(anew.err, "");
  EXPECT_TRUE(Parse("anew").tensors.contains("rejection_threshold"));
  for (const char* name : {"dual_coefficients", "intercepts", "support_vectors"}) {
    EXPECT_EQ(Parse("anew").tensors.at(name).values, Parse("dropped").tensors.at(name).values);
  }
  const Outcome lone = Add("box", "box --out " + Path("lone") + novel);
  EXPECT_EQ(lone.code, 2);
  EXPECT_THAT(lone.err, HasSubstr("views of every class"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "lone"));
}

TEST_F(TrainObjectClass, RefusesWhatIsNotNovel) {
  const std::size_t num_entries = NumEntries(folder_.path());
  const std::string out = " --out " + Path("m");
  const Outcome known = Train("three", "--folds 3 --novel " + Path("two") + out);
  EXPECT_EQ(known.code, 3);
  EXPECT_THAT(known.err, HasSubstr("this view is not novel: its class 'ball' is one to tell"));
  const Outcome missing = Train("three", "--novel " + Path("nowhere") + out);
  EXPECT_EQ(missing.code, 3);
  const Outcome folds = Train("two", "--folds 0 --novel " + Path("three") + out);
  EXPECT_EQ(folds.code, 2);
  EXPECT_THAT(folds.err, HasSubstr("--novel needs --folds"));
  EXPECT_THAT(Train("two", "--novel " + Path("three") + " --novel-split test" + out).err,
              HasSubstr("no view is in the split 'test'"));
  EXPECT_EQ(Train("two", "--max-lost 0.1" + out).code, 2);
  EXPECT_EQ(NumEntries(folder_.path()), num_entries);
}

}  // namespace
}  // namespace handcraft::tools
