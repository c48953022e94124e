// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "experiments/benchmarks/benchmark.h"
#include "lib/core/file.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

constexpr const char* kQuick =
    "bench --only load_model --repetitions 1 --data " HANDCRAFT_SOURCE_DIR
    "/datasets/samples/cornell_mini ";

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
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("ours [ms]"), HasSubstr("load_model")));
}

TEST(Bench, WritesTheStableKeys) {
  const TemporaryDirectory folder;
  const std::string file = (folder / "b.json").string();
  const Outcome outcome = RunLine(kQuick + ("--json " + file));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("load_model"));
  const auto json = nlohmann::json::parse(ReadTextFile(file));
  ASSERT_EQ(json.size(), 1U);
  for (const char* key :
       {"name", "what", "dissertation_ms", "peer", "peer_ms", "ours_ms", "ratio", "unit"}) {
    EXPECT_TRUE(json[0].contains(key)) << key;
  }
  EXPECT_EQ(json[0]["name"], "load_model");
  EXPECT_GT(json[0]["ours_ms"].get<double>(), 0.0);
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

TEST(Bench, ChecksItsOutputBeforeTheWork) {
  const TemporaryDirectory folder;
  EXPECT_EQ(RunLine(kQuick + ("--json " + (folder / "no/b.json").string())).code, 3);
}

}  // namespace
}  // namespace handcraft::tools
