// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "lib/model_io/model_writer.h"
#include "tests/support/read_tree.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::NumEntries;
using testing::Outcome;
using testing::RunLine;

class StudyFeatureAnalysis : public testing::ImageSetTest {
 protected:
  [[nodiscard]] std::string Line(const std::string& out, const std::string& more = "") const {
    return "study run feature-analysis --data " + set_.string() + " --out " +
           (folder_ / out).string() +
           " --features filters=laws_LL+edge_0+edge_90,window=1 --samples 400"
           " --classifier-samples 400 " +
           more;
  }
};

TEST_F(StudyFeatureAnalysis, WritesAReport) {
  const Outcome outcome = RunLine(Line("study"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("all features"),
                    HasSubstr("dissertation 1: edge filters"),
                    HasSubstr("usefulness: filters"),
                    HasSubstr("laws_LL; 1×1\n"),
                    HasSubstr("all but laws_LL; 1×1\n"),
                    HasSubstr("Report written to")));
  const auto json =
      nlohmann::json::parse(ReadTextFile((folder_ / "study" / "results.json").string()));
  EXPECT_EQ(json["num_samples"], 400);
  EXPECT_EQ(json["elimination"]["order"].size(), 3U);
  const std::filesystem::path model = folder_ / "study" / "pca.safetensors";
  const model_io::ModelFile pca = model_io::Parse(ReadFile(model), model.string());
  EXPECT_EQ(pca.metadata.at("hc.kind"), "pca");
  EXPECT_EQ(pca.tensors.at("eigenvalues").shape, (std::vector<std::int64_t>{3}));
  EXPECT_THAT(RunLine("inspect " + model.string()).out, HasSubstr("components"));
}

TEST_F(StudyFeatureAnalysis, WritesTheSameBytesForOneAndTwoThreads) {
  ASSERT_EQ(RunLine(Line("one", "--threads 1")).code, 0);
  ASSERT_EQ(RunLine(Line("two", "--threads 2")).code, 0);
  EXPECT_EQ(handcraft::testing::ReadTree(folder_ / "one"),
            handcraft::testing::ReadTree(folder_ / "two"));
}

TEST_F(StudyFeatureAnalysis, TakesNoFolderOfSomethingElse) {
  ASSERT_EQ(RunLine(Line("study")).code, 0);
  const auto before = handcraft::testing::ReadTree(folder_ / "study");
  EXPECT_THAT(RunLine(Line("study", "--ridge 2")).err,
              HasSubstr("another input \"study\": ridge = 1, now ridge = 2"));
  std::filesystem::create_directories(folder_ / "other/inputs");
  std::filesystem::create_directory(folder_ / "letters");
  WriteFileAtomically(folder_ / "other/inputs/study", "seed = 7\n");
  EXPECT_THAT(RunLine(Line("other")).err,
              HasSubstr("another input \"study\": seed = 7, now study = feature-analysis"));
  WriteFileAtomically(folder_ / "letters/letter.txt", "");
  EXPECT_THAT(RunLine(Line("letters")).err, HasSubstr("holds something else"));
  EXPECT_EQ(NumEntries(folder_ / "letters"), 1U);
  EXPECT_EQ(RunLine(Line("study")).code, 0);
  EXPECT_EQ(handcraft::testing::ReadTree(folder_ / "study"), before);
}

TEST_F(StudyFeatureAnalysis, LeavesNothingBehindWhenItFails) {
  const std::size_t before = NumEntries(folder_.path());
  const Outcome outcome = RunLine(Line("study", "--split nowhere"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere"));
  EXPECT_EQ(RunLine(Line("study", "--ridge 0")).code, 2);
  EXPECT_EQ(NumEntries(folder_.path()), before);
}

}  // namespace
}  // namespace handcraft::tools
