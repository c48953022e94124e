// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "lib/core/file.h"
#include "tests/tools/support/synth_test.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;

class DataSynthRegrasp : public testing::SynthTest {
 protected:
  [[nodiscard]] Outcome Make(const std::string& options) const {
    return Synth("regrasp", "--sensor perfect " + options);
  }
};

TEST_F(DataSynthRegrasp, MakesASetAndTellsOfIt) {
  const Outcome outcome = Make("--configurations 1 --poses 2 --holds 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["num_poses"], 8);
  EXPECT_EQ(json["num_holds"], 12);
  EXPECT_EQ(json["pairs"]["valid"], 12);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(datasets::ReadHoldSet(out_)));
  EXPECT_EQ(datasets::ReadDemonstrationSet(out_).items.size(), 8U);
  const Outcome again = Make("--configurations 1 --poses 2 --holds 3");
  EXPECT_THAT(again.out, HasSubstr("is complete, 8 poses and 12 holds"));
}

TEST_F(DataSynthRegrasp, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(Make("--family novel").code, 2);
  EXPECT_EQ(Make("--sensor eyes").code, 2);
  EXPECT_THAT(Make("--holds 0").err, HasSubstr("--holds: 0 given; it must be from 1 to"));
  EXPECT_THAT(Make("--configurations 0").err, HasSubstr("it must be from 1 to 10000"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace handcraft::tools
