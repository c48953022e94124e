// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/file.h"
#include "tests/support/expect_throws_message.h"
#include "tests/support/temporary_directory.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view kWhole = R"(name = "mine"
title = "Mine"
question = "Why?"
baseline = "few"
split = "class"
seed = 4
repetitions = { small = 1, full = 5 }
[data.train]
made = "trained"
images = { small = 9, full = 90 }
seed = 2
[data.test]
folder = "photos"
[evaluation]
pixels_per_image = 100
resamples = 50
[settings]
training_share = 0.2
samples = { small = 10, full = 1000 }
[[method]]
name = "many"
features = "all500"
[[method]]
name = "few"
features = "edges54"
energy = "log"
[grid]
ridge = [0, 0.5]
[claim]
source = "here"
worst_loss_points = 3.81
)";

// The least that is a study, with more lines before its tables.
std::string Minimal(const std::string& lines, const std::string& tables = "") {
  return "name = \"m\"\ntitle = \"M\"\n" + lines + "\n[data.train]\nfolder = \"d\"\n" + tables +
         "\n[[method]]\nname = \"a\"\n";
}

Study Parse(const std::string& text) { return ParseStudy(text, "s.toml", StudySize::kSmall); }

TEST(ParseStudy, ReadsEveryKey) {
  const Study study = ParseStudy(kWhole, "s.toml", StudySize::kFull);
  EXPECT_EQ(study.name, "mine");
  EXPECT_EQ(study.question, "Why?");
  EXPECT_EQ(study.baseline, "few");
  EXPECT_EQ(study.split, StudySplit::kClass);
  EXPECT_EQ(study.seed, 4U);
  EXPECT_EQ(study.repetitions, 5);
  EXPECT_EQ(study.train.family, "trained");
  EXPECT_EQ(study.train.num_images, 90);
  EXPECT_EQ(study.train.seed, 2U);
  EXPECT_EQ(study.test->folder, "photos");
  EXPECT_EQ(study.pixels_per_image, 100U);
  EXPECT_EQ(study.bootstrap_resamples, 50U);
  EXPECT_THAT(study.settings,
              ElementsAre(Setting{"training_share", "0.2"}, Setting{"samples", "1000"}));
  ASSERT_EQ(study.methods.size(), 2U);
  EXPECT_THAT(study.methods[1].settings,
              ElementsAre(Setting{"features", "edges54"}, Setting{"energy", "log"}));
  ASSERT_EQ(study.factors.size(), 1U);
  EXPECT_THAT(study.factors[0].values, ElementsAre("0", "0.5"));
  EXPECT_EQ(study.claim->worst_loss_points, 3.81);
}

TEST(ParseStudy, TakesTheValuesOfTheSize) {
  const Study study = ParseStudy(kWhole, "s.toml", StudySize::kSmall);
  EXPECT_EQ(study.repetitions, 1);
  EXPECT_EQ(study.train.num_images, 9);
  EXPECT_EQ(study.settings[1].value, "10");
}

TEST(ParseStudy, HasDefaults) {
  const Study study = Parse(Minimal(""));
  EXPECT_EQ(study.baseline, "a");
  EXPECT_EQ(study.split, StudySplit::kInstance);
  EXPECT_EQ(study.repetitions, 1);
  EXPECT_FALSE(study.test);
  EXPECT_FALSE(study.claim);
}

TEST(ParseStudy, RefusesUnknownKeysWithTheirLine) {
  EXPECT_THROWS_MESSAGE(Parse(Minimal("samples = 3")),
                        Error,
                        AllOf(HasSubstr("s.toml:3"), HasSubstr("\"samples\" is no key")));
  EXPECT_THROWS_MESSAGE(
      Parse(Minimal("", "[settings]\nridges = 3")), Error, HasSubstr("\"ridges\" is no key"));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("", "[grid]\nname = [1]")), Error, HasSubstr("\"name\""));
  EXPECT_THROWS_MESSAGE(
      Parse(Minimal("") + "feature = \"all500\"\n"), Error, HasSubstr("\"feature\""));
}

TEST(ParseStudy, RefusesWhatDoesNotFit) {
  const auto refuse = [](const std::string& lines, const std::string& message) {
    EXPECT_THROWS_MESSAGE(Parse(Minimal(lines)), Error, HasSubstr(message));
  };
  refuse("split = \"image\"", "give one of instance, class, picture, manifest");
  refuse("repetitions = 0", "repetitions must be a whole number");
  refuse("repetitions = 1.5", "repetitions must be a whole number");
  refuse("repetitions = { small = 1 }", "two entries");
  refuse("baseline = \"b\"", "no method is named \"b\"");
  refuse("seed = -1", "seed must be a whole number");
}

TEST(ParseStudy, RefusesSettingsThatDoNotFitWithTheirLine) {
  EXPECT_THROWS_MESSAGE(Parse(Minimal("", "[settings]\nridge = -1")),
                        Error,
                        AllOf(HasSubstr("s.toml:7"), HasSubstr("ridge is \"-1\"")));
  EXPECT_THROWS_MESSAGE(
      Parse(Minimal("", "[settings]\nridge = true")), Error, HasSubstr("a text or a number"));
  EXPECT_THROWS_MESSAGE(
      Parse(Minimal("", "[grid]\nridge = [0, -2]")), Error, HasSubstr("ridge is \"-2\""));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("", "[grid]\nridge = []")), Error, HasSubstr("no list"));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("", "[grid]\nridge = [1, 1]")), Error, HasSubstr("twice"));
}

TEST(ParseStudy, RefusesSettingsThatAClassifierDoesNotRead) {
  const std::string lda = "[[method]]\nname = \"b\"\nclassifier = \"lda\"\n";
  EXPECT_NO_THROW(Parse(Minimal("") + lda + "shrinkage = \"auto\"\n"));
  EXPECT_NO_THROW(
      Parse(Minimal("") + "[grid]\nclassifier = [\"logistic\", \"lda\"]\nprior = [0, 0.5]\n"));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("") + "shrinkage = 0.3\n"),
                        Error,
                        HasSubstr("shrinkage is not read by the classifier of method \"a\""));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("") + lda + "ridge = 3\n"),
                        Error,
                        HasSubstr("ridge is not read by the classifier of method \"b\""));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("") + lda + "[grid]\nprior = [0, 0.5]\n"),
                        Error,
                        HasSubstr("prior is not read by the classifier of method \"a\""));
}

TEST(ParseStudy, RefusesAmbiguousMethods) {
  EXPECT_THROWS_MESSAGE(
      Parse(Minimal("") + "[[method]]\nname = \"a\"\n"), Error, HasSubstr("two methods"));
  EXPECT_THROWS_MESSAGE(Parse(Minimal("") + "ridge = 1\n[grid]\nridge = [1, 2]\n"),
                        Error,
                        HasSubstr("ridge is set by the method \"a\" too"));
  EXPECT_THROWS_MESSAGE(
      Parse(Minimal("") + "[[method]]\nname = \"a/b\"\n"), Error, HasSubstr("use letters"));
  EXPECT_THROWS_MESSAGE(Parse("name = \"m\"\ntitle = \"M\"\n[data.train]\nfolder = \"d\"\n"),
                        Error,
                        HasSubstr("at least one [[method]]"));
}

TEST(ParseStudy, RefusesUnclearData) {
  const auto with_data = [](const std::string& lines) {
    return "name = \"m\"\ntitle = \"M\"\n[data.train]\n" + lines + "\n[[method]]\nname = \"a\"\n";
  };
  EXPECT_THROWS_MESSAGE(Parse(with_data("")), Error, HasSubstr("either a folder or made"));
  EXPECT_THROWS_MESSAGE(Parse(with_data("folder = \"d\"\nmade = \"trained\"")),
                        Error,
                        HasSubstr("either a folder or made"));
  EXPECT_THROWS_MESSAGE(
      Parse(with_data("made = \"toys\"\nimages = 3")), Error, HasSubstr("made is \"toys\""));
  EXPECT_THROWS_MESSAGE(
      Parse(with_data("folder = \"d\"\nimages = 3")), Error, HasSubstr("\"images\" is no key"));
}

TEST(ReadStudy, NamesTheFile) {
  const testing::TemporaryDirectory folder;
  WriteFileAtomically(folder / "mine.toml", "name = 3\n");
  EXPECT_THROWS_MESSAGE(
      ReadStudy(folder / "mine.toml", StudySize::kSmall), Error, HasSubstr("mine.toml:1"));
  EXPECT_THROWS_MESSAGE(ReadStudy(folder / "none", StudySize::kSmall), Error, HasSubstr("none"));
}

}  // namespace
}  // namespace handcraft::experiments
