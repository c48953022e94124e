// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "lib/core/file.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/read_tree.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

class StudyRunTest : public ::testing::Test {
 protected:
  StudyRunTest() {
    handcraft::testing::WriteRoughSet(folder_ / "data");
    WriteFileAtomically(folder_ / "study.toml",
                        "name = \"mine\"\ntitle = \"Mine\"\n[data.train]\nfolder = \"nowhere\"\n"
                        "[settings]\nsamples = { small = 100, full = 200 }\ntraining_share = 0.5\n"
                        "ridge = 1\n[evaluation]\nresamples = 20\n[[method]]\nname = \"a\"\n"
                        "features = \"filters=laplacian,window=1\"\n[[method]]\nname = \"b\"\n"
                        "features = \"filters=edge_0,window=1\"\n");
  }
  [[nodiscard]] Outcome Run(const std::string& more) const {
    return RunLine("study run " + Path("study.toml") + " --data " + Path("data") + " --out " +
                   Path("out") + " --threads 1 " + more);
  }
  [[nodiscard]] std::string Path(const std::string& name) const {
    return (folder_ / name).string();
  }

  handcraft::testing::TemporaryDirectory folder_;
};

TEST_F(StudyRunTest, RunsAFileOnOtherDataAndGoesOn) {
  const Outcome outcome = Run("");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("a,repetition=1"));
  EXPECT_THAT(outcome.out, HasSubstr("2 cells\n"));
  EXPECT_THAT(ReadTextFile(folder_ / "out/results.csv"), HasSubstr("\"b,repetition=1\",b,1,even"));
  EXPECT_THAT(Run("").out, HasSubstr("2 cells, 2 of an earlier run"));
}

TEST_F(StudyRunTest, TakesNoFolderOfSomethingElse) {
  ASSERT_EQ(RunLine("study run feature-analysis --data " + Path("data") + " --out " + Path("out") +
                    " --features filters=laws_LL+edge_0+edge_90,window=1 --samples 100 "
                    "--classifier-samples 100")
                .code,
            0);
  const auto before = handcraft::testing::ReadTree(folder_ / "out");
  const Outcome outcome = Run("");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("another input \"study\": study = feature-analysis, now "));
  EXPECT_EQ(handcraft::testing::ReadTree(folder_ / "out"), before);
  std::filesystem::remove_all(folder_ / "out");
  std::filesystem::create_directory(folder_ / "out");
  WriteFileAtomically(folder_ / "out/letter.txt", "Dear");
  const Outcome letters = Run("");
  EXPECT_EQ(letters.code, 2);
  EXPECT_THAT(letters.err, HasSubstr("holds something else than the results of a study"));
  EXPECT_EQ(ReadTextFile(folder_ / "out/letter.txt"), "Dear");
}

TEST_F(StudyRunTest, SaysWhichCellIsWorkedOutAgain) {
  ASSERT_EQ(Run("").code, 0);
  const std::filesystem::path cell = folder_ / "out/cells/a,repetition=1.json";
  WriteFileAtomically(cell, std::string_view(ReadTextFile(cell)).substr(0, 1000));
  const Outcome outcome = Run("");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("a,repetition=1 is worked out again"));
  EXPECT_THAT(outcome.out, HasSubstr("2 cells, 1 of an earlier run"));
}

TEST_F(StudyRunTest, TakesTheSizeAskedFor) {
  ASSERT_EQ(Run("--size full --json").code, 0);
  EXPECT_THAT(ReadTextFile(folder_ / "out/inputs/study"), HasSubstr("settings.samples = 200"));
  const Outcome other = Run("--size small");
  EXPECT_EQ(other.code, 3);
  EXPECT_THAT(other.err, HasSubstr("another input \"study\""));
}

TEST_F(StudyRunTest, TestsOnOtherPicturesAndTellsMachines) {
  handcraft::testing::WriteRoughSet(folder_ / "other", 2);
  const Outcome outcome = Run("--json --test-data " + Path("other"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["study"], "mine");
  EXPECT_EQ(json["num_cells"], 2);
  EXPECT_EQ(json["num_resumed"], 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/inputs/data.test"));
}

TEST_F(StudyRunTest, RunsSomeOfTheMethods) {
  const Outcome outcome = Run("--methods a --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["num_cells"], 1);
  EXPECT_EQ(Run("--methods a,c").code, 2);
  EXPECT_THAT(Run("--methods b").err, HasSubstr("compared with a"));
}

TEST_F(StudyRunTest, NamesTheStudiesThereAre) {
  const Outcome outcome = RunLine("study run chapter9 --out " + Path("out"));
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("chapter3-trained-objects"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(StudyRunTest, AsksForWhatIsMissing) {
  EXPECT_THAT(RunLine("study run").err, HasSubstr("STUDY is required"));
  EXPECT_THAT(RunLine("study run chapter3-speed").err, HasSubstr("--out is required"));
  EXPECT_EQ(RunLine("study run chapter3-speed").code, 2);
  EXPECT_THAT(RunLine("study run chapter3-speed --ouT x").err, HasSubstr("--ouT"));
}

TEST_F(StudyRunTest, NamesTheFolderThatIsMissing) {
  const Outcome outcome =
      RunLine("study run " + Path("study.toml") + " --out " + Path("out") + " --threads 1");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace handcraft::tools
