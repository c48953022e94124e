// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/view_set.h"
#include "lib/core/file.h"
#include "tests/tools/support/synth_test.h"

namespace handcraft::tools {
namespace {

using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;
using ::testing::StartsWith;

class DataSynthViews : public testing::SynthTest {
 protected:
  [[nodiscard]] Outcome Make(const std::string& kind, const std::string& options) const {
    return Synth(kind, options, "baseline_m = 0.1\n");
  }
};

TEST_F(DataSynthViews, MakesATurntable) {
  const Outcome outcome = Make("turntable", "--views 1 --sensor stereo-bm");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("Wrote 6 views to "));
  const datasets::ViewSet set = datasets::ReadViewSet(out_);
  EXPECT_EQ(set.items[0].object_class, "coffee_can");
  EXPECT_EQ(set.items[0].split, "train");
  const std::string options = ReadTextFile(out_ / "dataset.toml");
  EXPECT_THAT(options, StartsWith("kind = \"turntable\"\n"));
  EXPECT_THAT(options, HasSubstr("baseline_m = 0.1\n"));
  EXPECT_THAT(options, HasSubstr("sensor = \"stereo-bm\"\n"));
}

TEST_F(DataSynthViews, MovesTheObjectsAndTakesItsOptions) {
  const Outcome outcome = Make("moved",
                               "--views 1 --family regrasp --sensor depth-camera --seed 5 "
                               "--camera-noise-m 0.005 --camera-noise-deg 0.5 --threads 1 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["num_views"], 4);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(datasets::ReadViewSet(out_)));
  const std::string options = ReadTextFile(out_ / "dataset.toml");
  EXPECT_THAT(options, HasSubstr("family = \"regrasp\"\nsensor = \"depth-camera\"\nseed = 5\n"));
  EXPECT_THAT(options, HasSubstr("camera_noise_m = 0.005\ncamera_noise_deg = 0.5\n"));
}

TEST_F(DataSynthViews, RefusesValuesItDoesNotKnow) {
  EXPECT_THAT(Make("moved", "--views 0").err, HasSubstr("--views: 0 given; it must be from 1 to"));
  EXPECT_THAT(Make("moved", "--camera-noise-m 1").err,
              HasSubstr("--camera-noise-m: 1 given; it must be from 0 to 0.05"));
  EXPECT_EQ(Make("turntable", "--family trained").code, 2);
  EXPECT_EQ(Make("turntable", "--sensor sonar").code, 2);
  EXPECT_EQ(RunLine("data synth moved").code, 2) << "no folder";
  const Outcome outcome = RunLine("data synth moved --out " + out_.string() + " --camera no.toml");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("no.toml: cannot open"));
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace handcraft::tools
