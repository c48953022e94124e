// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "experiments/benchmarks/benchmark.h"
#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

constexpr const char* kQuick = "bench --only load_model --repetitions 1 ";
constexpr const char* kSamples = HANDCRAFT_SOURCE_DIR "/datasets/samples/cornell_mini";

TEST(Bench, ListsEveryBenchmark) {
  const Outcome outcome = RunLine("bench --list");
  EXPECT_EQ(outcome.code, 0);
  for (const experiments::Benchmark& benchmark : experiments::AllBenchmarks()) {
    EXPECT_THAT(outcome.out, HasSubstr(std::string(benchmark.name)));
  }
}

TEST(Bench, PrintsATableOfTheOneAskedFor) {
  const Outcome outcome = RunLine(kQuick);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("ours [ms]  target [ms]"), HasSubstr("load_model")));
}

TEST(Bench, WritesTheStableKeys) {
  const TemporaryDirectory folder;
  const std::string file = (folder / "b.json").string();
  const Outcome outcome = RunLine(kQuick + ("--json " + file));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("load_model"));
  const auto json = nlohmann::json::parse(ReadTextFile(file));
  ASSERT_EQ(json.size(), 1U);
  for (const char* key : {"name",
                          "what",
                          "dissertation_ms",
                          "target_ms",
                          "peer",
                          "peer_ms",
                          "ours_ms",
                          "ratio",
                          "unit"}) {
    EXPECT_TRUE(json[0].contains(key)) << key;
  }
  EXPECT_EQ(json[0]["name"], "load_model");
  EXPECT_GT(json[0]["ours_ms"].get<double>(), 0.0);
  EXPECT_EQ(json[0]["target_ms"], 1.0);
}

TEST(Bench, PrintsNothingButJsonWhenAsked) {
  EXPECT_EQ(nlohmann::json::parse(RunLine(std::string(kQuick) + "--json").out).size(), 1U);
}

TEST(Bench, NamesAnUnknownBenchmarkAndThoseThereAre) {
  const Outcome outcome = RunLine("bench --only score");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("no benchmark 'score'; there are: "), HasSubstr("load_model")));
}

TEST(Bench, RefusesOptionsThatNothingReads) {
  Outcome outcome = RunLine(std::string(kQuick) + "--only score_all500_vga --data " + kSamples);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--data is read by none of: score_all500_vga, load_model"));
  outcome = RunLine("bench --only train_irls_154188x500 --repetitions 2");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--repetitions is read by none of: train_irls_154188x500"));
  for (const std::string option : {"--only load_model", "--repetitions 2", "--data d", "--json"}) {
    EXPECT_EQ(RunLine("bench --list " + option).code, 2) << option;
  }
}

TEST(Bench, ChecksItsDataBeforeTheWork) {
  const Outcome outcome = RunLine("bench --data no/such");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no/such"));
}

TEST(Bench, NeverOverwritesAPicture) {
  const TemporaryDirectory folder;
  testing::WriteImageSet(folder / "set");
  const auto before = ReadFile(folder / "set/p1.png");
  const Outcome outcome = RunLine("bench --data " + (folder / "set").string() + " --json " +
                                  (folder / "set/p1.png").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("would overwrite the input"));
  EXPECT_EQ(ReadFile(folder / "set/p1.png"), before);
}

TEST(Bench, ChecksItsOutputBeforeTheWork) {
  const TemporaryDirectory folder;
  EXPECT_EQ(RunLine(kQuick + ("--json " + (folder / "no/b.json").string())).code, 3);
}

}  // namespace
}  // namespace handcraft::tools
