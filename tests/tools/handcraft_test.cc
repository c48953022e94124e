// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/handcraft.h"

#include <filesystem>
#include <ostream>
#include <regex>
#include <sstream>
#include <streambuf>
#include <utility>

#include <gmock/gmock.h>

#include "lib/runtime/handcraft_runtime.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::RunLine;
using ::testing::StartsWith;

const std::vector<std::string>& AllCommands() {
  static const std::vector<std::string> commands = {"data info",
                                                    "data check",
                                                    "data import folders",
                                                    "data import labelme",
                                                    "data import coco",
                                                    "data import cvat",
                                                    "data import jacquard",
                                                    "data import cornell",
                                                    "train grasp-points",
                                                    "train logistic",
                                                    "train svm",
                                                    "evaluate",
                                                    "predict",
                                                    "inspect",
                                                    "check-model",
                                                    "bench"};
  return commands;
}

std::string ExampleOf(const std::string& command) {
  const std::string help = RunLine(command + " --help").out;
  const std::size_t at = help.find("Example:\n  handcraft ");
  EXPECT_NE(at, std::string::npos) << command;
  const std::size_t begin = help.find("handcraft ", at) + std::string("handcraft ").size();
  return help.substr(begin, help.find('\n', begin) - begin);
}

TEST(RunHandcraft, TellsItsVersion) {
  const Outcome outcome = RunLine("--version");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, std::string("handcraft ") + hc_version() + "\n");
  EXPECT_EQ(outcome.err, "");
}

TEST(RunHandcraft, HelpsOnStandardOutput) {
  const Outcome outcome = RunLine("--help");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("train"), HasSubstr("check-model")));
  EXPECT_EQ(outcome.err, "");
}

TEST(RunHandcraft, EveryCommandHelpsWithAnExampleOfItself) {
  for (const std::string& command : AllCommands()) {
    const Outcome outcome = RunLine(command + " --help");
    EXPECT_EQ(outcome.code, 0) << command;
    EXPECT_EQ(outcome.err, "") << command;
    EXPECT_THAT(outcome.out, HasSubstr("--json")) << command;
    EXPECT_THAT(ExampleOf(command), StartsWith(command));
  }
}

// Flag values, C++ types, validators and words of CLI11.
TEST(RunHandcraft, HelpShowsNothingOfItsInside) {
  std::vector<std::string> lines = AllCommands();
  lines.insert(lines.end(), {"", "data", "data import", "train"});
  for (const std::string& line : lines) {
    const std::string help = RunLine(line + " --help").out;
    for (const char* word : {"{", "UINT", "FLOAT", "BOOLEAN", ":NUMBER", "ubcommand", "\n\n\n"}) {
      EXPECT_THAT(help, Not(HasSubstr(word))) << line;
    }
  }
}

TEST(RunHandcraft, NamesAWrongCommandAndTheRightOnes) {
  const Outcome outcome = RunLine("trian");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              AllOf(StartsWith("handcraft: error: no command 'trian'; there are: data, train"),
                    HasSubstr("Try 'handcraft --help'.")));
}

// What "$OUT" gives when OUT was not set.
TEST(RunHandcraft, RefusesAnEmptyPath) {
  for (const char* line : {"train logistic t.csv --label y --out ''",
                           "train grasp-points d --out ''",
                           "predict m p --out ''",
                           "evaluate m d --html ''",
                           "data import cornell d --out ''"}) {
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 2) << line;
    EXPECT_THAT(outcome.err, HasSubstr(": an empty path was given")) << line;
  }
  EXPECT_THAT(RunLine("data info ''").err, HasSubstr("DIR: an empty path was given"));
}

TEST(RunHandcraft, AsksForTheMissingCommand) {
  EXPECT_EQ(RunLine("").code, 2);
  EXPECT_THAT(RunLine("").err, HasSubstr("a command is missing; there are: data, "));
  EXPECT_THAT(
      RunLine("data").err,
      AllOf(HasSubstr("a command is missing; there are: info, check, clouds, export, import"),
            HasSubstr("Try 'handcraft data --help'.")));
}

TEST(RunHandcraft, RefusesWrongOptionsWithAHint) {
  for (const std::string& command : AllCommands()) {
    const Outcome outcome = RunLine(command + " a b --no-such-option");
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_EQ(outcome.out, "") << command;
    EXPECT_THAT(outcome.err,
                AllOf(StartsWith("handcraft: error: "),
                      HasSubstr("Try 'handcraft " + command + " --help'.")));
  }
  EXPECT_THAT(RunLine("train logistic t --label l --ridge x").err, HasSubstr("--ridge"));
  // In the order in which they were given.
  EXPECT_THAT(RunLine("inspect m --first 1 --second").err,
              HasSubstr("The following arguments were not expected: --first 1 --second"));
}

TEST(RunHandcraft, HintsAtHelpForAValueOutOfRange) {
  const TemporaryDirectory folder;
  testing::WriteTable(folder / "t.csv");
  const Outcome outcome =
      RunLine("train logistic " + (folder / "t.csv").string() + " --label class --ridge -1");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("ridge"), HasSubstr("Try 'handcraft train logistic --help'.")));
}

TEST(RunHandcraft, RefusesEveryWrongNumberInOneForm) {
  const std::regex number_option("\n  (--[a-z-]+) (NUMBER|INT) ");
  for (const std::string& command : AllCommands()) {
    const std::string help = RunLine(command + " --help").out;
    for (std::sregex_iterator match(help.begin(), help.end(), number_option), end; match != end;
         ++match) {
      const std::string option = (*match)[1];
      std::string line = command + " a b ";
      const Outcome outcome = RunLine(line.append(option).append(" x"));
      EXPECT_EQ(outcome.code, 2) << command;
      EXPECT_THAT(outcome.err, HasSubstr(option + ": x given; it must be a ")) << command;
    }
  }
}

// The rules are the library's, whose messages name fields; people gave an option.
TEST(RunHandcraft, NamesTheOptionTheValueAndTheRule) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"data import cornell s --out o --good-share 0",
       "--good-share: 0 given; it must be in (0, 1]"},
      {"data import cornell s --out o --max-images -1",
       "--max-images: -1 given; it must be 0 or more"},
      {"train grasp-points d --out o --samples -5", "--samples: -5 given; it must be 0 or more"},
      {"train grasp-points d --out o --bad-per-good inf",
       "--bad-per-good: inf given; it must be greater than 0"},
      {"train grasp-points d --out o --ridge -1",
       "--ridge: -1 given; it must be a finite number >= 0"},
      {"train logistic t --label l --warm-start 1", "--warm-start: 1 given; it must be in [0, 1)"},
      {"evaluate m d --resamples 0", "--resamples: 0 given; it must be at least 1"},
      {"evaluate m d --pixels-per-image -3", "--pixels-per-image: -3 given; it must be at least 2"},
      {"evaluate m d --top 10001", "--top: 10001 given; it must be from 1 to 10000"},
      {"predict m i --min-probability 1", "--min-probability: 1 given; it must be in [0, 1)"},
      {"bench --repetitions 1001", "--repetitions: 1001 given; it must be from 1 to 1000"}};
  for (const auto& [line, message] : cases) {
    EXPECT_THAT(RunLine(line).err, StartsWith("handcraft: error: " + message + "\nTry ")) << line;
  }
}

TEST(RunHandcraft, TakesALinkRoundInACircleForBadInput) {
  const TemporaryDirectory folder;
  std::filesystem::create_symlink("y", folder / "y");
  const std::string loop = (folder / "y").string();
  for (const char* words : {"data check LOOP",
                            "data info LOOP",
                            "data preview LOOP --out LOOP.png",
                            "data split LOOP",
                            "evaluate m d --json LOOP --html LOOP"}) {
    const std::string line = std::regex_replace(words, std::regex("LOOP"), loop);
    const Outcome outcome = RunLine(line);
    EXPECT_EQ(outcome.code, 3) << line;
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr(loop), HasSubstr("Too many levels of symbolic links")));
    EXPECT_THAT(outcome.err, Not(HasSubstr("bug"))) << line;
  }
  testing::WriteImageSet(folder / "set");
  const std::filesystem::path mask = folder / "set/p0_mask.png";
  std::filesystem::remove(mask);
  std::filesystem::create_symlink(mask.filename(), mask);
  const Outcome check = RunLine("data check " + (folder / "set").string());
  EXPECT_EQ(check.code, 3);
  EXPECT_THAT(check.out + check.err, HasSubstr("p0_mask.png: cannot open: Too many levels"));
}

// A stream that takes nothing, as /dev/full.
class FullStream : public std::streambuf {
 protected:
  int overflow(int /*byte*/) override { return traits_type::eof(); }
  int sync() override { return -1; }
};

TEST(RunHandcraft, SaysWhenStandardOutputTakesNoMore) {
  const TemporaryDirectory folder;
  testing::WriteImageSet(folder / "set");
  const std::string set = (folder / "set").string();
  FullStream full;
  std::ostream out(&full);
  std::ostringstream err;
  const std::vector<const char*> args = {"data", "info", set.c_str()};
  EXPECT_EQ(RunHandcraft(args, out, err), 3);
  EXPECT_THAT(err.str(), HasSubstr("standard output: cannot write"));
}

// The examples in --help work as printed, from a folder that looks like the project's root after
// ./demo. `bench` is left out: it takes minutes.
TEST(RunHandcraft, ExamplesWorkAsPrinted) {
  const TemporaryDirectory root;
  const std::filesystem::path source = std::filesystem::absolute(HANDCRAFT_SOURCE_DIR);
  for (const char* name : {"datasets", "tests", "docs"}) {
    std::filesystem::create_directory_symlink(source / name, root / name);
  }
  std::filesystem::create_directories(root / "out/demo");
  testing::TrainGraspPoints(source / "datasets/samples/cornell_mini",
                            root / "out/demo/grasp_points.safetensors");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(root.path());
  for (const std::string& command : AllCommands()) {
    if (command == "bench") continue;
    const Outcome outcome = RunLine(ExampleOf(command));
    EXPECT_EQ(outcome.code, 0) << ExampleOf(command) << '\n' << outcome.err;
  }
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace handcraft::tools
