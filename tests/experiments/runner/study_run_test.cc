// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_run.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "datasets/synthetic/grasp_point_set.h"
#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

class RunStudyTest : public ::testing::Test {
 protected:
  RunStudyTest() { testing::WriteRoughSet(folder_ / "data"); }

  [[nodiscard]] StudyRun Run(const std::string& out, int num_threads = 1) const {
    return RunStudy(study_, {.out = folder_ / out, .num_threads = num_threads});
  }
  [[nodiscard]] std::string ResultsOf(const std::string& out) const {
    return ReadTextFile(folder_ / out / "results.csv");
  }

  testing::TemporaryDirectory folder_;
  Study study_ = testing::SmallStudy(folder_ / "data");
};

TEST_F(RunStudyTest, WorksOutEveryCell) {
  const StudyRun run = Run("out");
  ASSERT_EQ(run.cells.size(), 8U);
  ASSERT_EQ(run.results.size(), 8U);
  EXPECT_EQ(run.num_resumed, 0U);
  for (const CellResult& result : run.results) {
    EXPECT_EQ(result.groups.back().num_images, 4U);
    EXPECT_GT(result.groups.back().auc.value, 0.6);  // rough and smooth are told apart
    EXPECT_EQ(result.images.size(), 4U);
  }
  EXPECT_TRUE(std::filesystem::exists(ModelFileOf(folder_ / "out", run.cells[0])));
  EXPECT_THAT(ReadTextFile(folder_ / "out/times.csv"), HasSubstr(run.cells[7].id));
}

TEST_F(RunStudyTest, GivesTheSameBytesAgainAndForAnyNumberOfThreads) {
  static_cast<void>(Run("one"));
  static_cast<void>(Run("three", 3));
  EXPECT_EQ(ResultsOf("three"), ResultsOf("one"));
}

TEST_F(RunStudyTest, GoesOnAfterSigkillToTheSameBytes) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    StudyRunOptions options{.out = folder_ / "killed"};
    options.progress = [](std::string_view stage, std::size_t done, std::size_t) {
      if (stage == "cells" && done == 3) static_cast<void>(raise(SIGKILL));
    };
    static_cast<void>(RunStudy(study_, options));
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "killed/results.csv"));
  WriteFileAtomically(folder_ / "killed/cells/half.json.Xy12ab", "{");  // as a killed write leaves
  EXPECT_EQ(Run("killed").num_resumed, 3U);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "killed/cells/half.json.Xy12ab"));
  static_cast<void>(Run("undisturbed"));
  EXPECT_EQ(ResultsOf("killed"), ResultsOf("undisturbed"));
}

TEST_F(RunStudyTest, DoesNotRedoFinishedCells) {
  const StudyRun first = Run("out");
  const std::filesystem::path file = ResultFileOf(folder_ / "out", first.cells[2]);
  const auto written = std::filesystem::last_write_time(file);
  EXPECT_EQ(Run("out").num_resumed, 8U);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
}

TEST_F(RunStudyTest, WorksOutAgainWhatHasLostItsModel) {
  const StudyRun first = Run("out");
  const std::string results = ResultsOf("out");
  const std::filesystem::path model = ModelFileOf(folder_ / "out", first.cells[1]);
  std::filesystem::remove(model);
  WriteFileAtomically(ModelFileOf(folder_ / "out", first.cells[2]), "half");
  const StudyRun again = Run("out");
  EXPECT_EQ(again.num_resumed, 6U);
  EXPECT_EQ(again.redone.size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(model));
  EXPECT_EQ(ResultsOf("out"), results);
}

TEST_F(RunStudyTest, LeavesTheFilesOfOthers) {
  const StudyRun first = Run("out");
  const std::filesystem::path file = ResultFileOf(folder_ / "out", first.cells[0]);
  WriteFileAtomically(file.parent_path() / "notes.txt", "mine");
  WriteFileAtomically(file.string() + ".abc123", "half a result");
  std::filesystem::create_directories(file.parent_path() / "folder.d/deep");
  static_cast<void>(Run("out"));
  EXPECT_EQ(ReadTextFile(file.parent_path() / "notes.txt"), "mine");
  EXPECT_TRUE(std::filesystem::exists(file.parent_path() / "folder.d/deep"));
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".abc123"));
}

TEST_F(RunStudyTest, MakesNothingBeforeAllFoldersAreThere) {
  study_.train = {.family = "novel", .num_images = 1};
  study_.test = DataSource{.folder = (folder_ / "nowhere").string()};
  EXPECT_THROWS_MESSAGE(Run("out"), Error, HasSubstr("nowhere"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(RunStudyTest, RefusesAnotherStudyByName) {
  static_cast<void>(Run("out"));
  study_.settings[0].value = "150";
  EXPECT_THROWS_MESSAGE(Run("out"),
                        Error,
                        HasSubstr("\"study\": settings.samples = 200, now settings.samples = 150"));
}

TEST_F(RunStudyTest, RefusesOtherPicturesByName) {
  static_cast<void>(Run("out"));
  testing::WriteRoughSet(folder_ / "data", 2);
  EXPECT_THROWS_MESSAGE(Run("out"), Error, HasSubstr("another input \"data.train\""));
}

TEST_F(RunStudyTest, WorksOutAgainWhatHasTheModelOfAnother) {
  const StudyRun first = Run("out");
  const std::string results = ResultsOf("out");
  const std::filesystem::path model = ModelFileOf(folder_ / "out", first.cells[1]);
  const std::vector<std::uint8_t> bytes = ReadFile(model);
  std::filesystem::copy_file(ModelFileOf(folder_ / "out", first.cells[0]),
                             model,
                             std::filesystem::copy_options::overwrite_existing);
  const StudyRun again = Run("out");
  ASSERT_EQ(again.redone.size(), 1U);
  EXPECT_THAT(again.redone[0], HasSubstr("is not the model that the cell was scored with"));
  EXPECT_EQ(ReadFile(model), bytes);
  EXPECT_EQ(ResultsOf("out"), results);
}

TEST_F(RunStudyTest, RefusesAFolderWhoseInputsAreNotKnown) {
  static_cast<void>(Run("out"));
  std::filesystem::remove(folder_ / "out/inputs/study");
  EXPECT_THROWS_MESSAGE(static_cast<void>(Run("out")),
                        Error,
                        HasSubstr("study: is missing, and what the finished cells were made of"));
}

TEST_F(RunStudyTest, WorksOutAgainWhatIsCutOffOrChangedAndSaysSo) {
  const StudyRun first = Run("out");
  EXPECT_TRUE(first.redone.empty());
  const std::string results = ResultsOf("out");
  const std::filesystem::path cut = ResultFileOf(folder_ / "out", first.cells[2]);
  const std::string whole = ReadTextFile(cut);
  WriteFileAtomically(cut, std::string_view(whole).substr(0, whole.size() / 2));
  const std::filesystem::path changed = ResultFileOf(folder_ / "out", first.cells[5]);
  std::string text = ReadTextFile(changed);
  const std::string number = "\"num_images\": 4";
  ASSERT_NE(text.find(number), std::string::npos);
  text.replace(text.find(number), number.size(), "\"num_images\": 5");
  WriteFileAtomically(changed, text);
  const StudyRun again = Run("out");
  EXPECT_EQ(again.num_resumed, 6U);
  ASSERT_EQ(again.redone.size(), 2U);
  EXPECT_THAT(again.redone[0], HasSubstr(first.cells[2].id + " is worked out again"));
  EXPECT_THAT(again.redone[1], HasSubstr("has been changed since it was written"));
  EXPECT_EQ(ResultsOf("out"), results);
  EXPECT_TRUE(Run("out").redone.empty());
}

TEST_F(RunStudyTest, WritesNothingWhereARegionNeedsDepth) {
  study_.methods[1].settings.push_back({"region", "object"});
  EXPECT_THROWS_MESSAGE(Run("out"), Error, HasSubstr("as 8 of 8 pictures"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(RunStudyTest, TellsTheStagesOfTheSearchSpace) {
  const auto set = synthetic::MakeGraspPointSet(folder_ / "made",
                                                {.num_images = 4,
                                                 .camera = {.width_px = 160,
                                                            .height_px = 120,
                                                            .focal_px = 131.25F,
                                                            .centre_u_px = 79.5F,
                                                            .centre_v_px = 59.5F}})
                       .set;
  study_.train = {.folder = set.root.string()};
  study_.split = StudySplit::kPicture;
  study_.methods[1].settings.push_back({"region", "object"});
  study_.factors.clear();
  study_.repetitions = 1;
  const StudyRun run = Run("out");
  EXPECT_TRUE(run.results[0].search_space.stages.empty());
  ASSERT_FALSE(run.results[1].search_space.stages.empty());
  EXPECT_EQ(run.results[1].search_space.stages.front().num_pixels, 160.0 * 120.0);
  EXPECT_THAT(ReadTextFile(folder_ / "out/search_space.csv"),
              HasSubstr("\"edge,repetition=1\",0,region,"));
  const std::string depth = set.items[0].Companion(datasets::kDepth);
  WriteFileAtomically(set.root / depth,
                      ReadTextFile(set.root / set.items[1].Companion(datasets::kDepth)));
  EXPECT_THROWS_MESSAGE(Run("out"), Error, HasSubstr("another input \"data.depth\""));
}

TEST_F(RunStudyTest, RefusesNoThreads) {
  EXPECT_THROWS_MESSAGE(Run("out", 0), Error, HasSubstr("StudyRunOptions.num_threads"));
}

}  // namespace
}  // namespace handcraft::experiments
