// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/demonstration_set.h"
#include "lib/core/file.h"
#include "tests/tools/support/synth_test.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

class DataSynthDemonstrations : public testing::SynthTest {
 protected:
  [[nodiscard]] Outcome Make(const std::string& options) const {
    return Synth("demonstrations", "--sensor perfect --views 1 " + options);
  }
};

TEST_F(DataSynthDemonstrations, MakesASetAndTellsOfIt) {
  const Outcome outcome = Make("--poses 2 --family regrasp --threads 1");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Wrote 8 poses to "));
  EXPECT_THAT(outcome.out, HasSubstr("spray_bottle"));
  EXPECT_EQ(datasets::ReadDemonstrationSet(out_).items.size(), 8U);
  const Outcome preview = RunLine("data preview " + out_.string() + " --poses --out " +
                                  (folder_ / "sheet.png").string());
  EXPECT_EQ(preview.code, 0) << preview.err;
}

TEST_F(DataSynthDemonstrations, TellsMachinesMore) {
  const Outcome outcome = Make("--poses 1 --family regrasp --seed 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["num_poses"], 4);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(datasets::ReadDemonstrationSet(out_)));
  ASSERT_EQ(json["classes"].size(), 4U);
  const auto& report = json["classes"][0];
  EXPECT_EQ(report["class"], "water_bottle");
  EXPECT_EQ(report["shown"]["valid"], 1);
  EXPECT_GT(report["sampled"]["near the table"], 0);
  EXPECT_GT(report["width_m"]["mean"], 0.0);
  EXPECT_THAT(ReadTextFile(out_ / "dataset.toml"), HasSubstr("seed = 3\n"));
}

TEST_F(DataSynthDemonstrations, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(Make("--family trained").code, 2);
  EXPECT_EQ(Make("--size huge").code, 2);
  EXPECT_EQ(Make("--size full --poses 3").code, 2);
  EXPECT_THAT(Make("--poses -1").err, HasSubstr("--poses: -1 given; it must be from 1 to"));
  EXPECT_THAT(Make("--poses 0").err, HasSubstr("--poses: 0 given; it must be from 1 to 1000000"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace handcraft::tools
