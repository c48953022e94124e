// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/datasets/small_view_set.h"
#include "tests/support/temporary_directory.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using handcraft::testing::TemporaryDirectory;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunLine;

class DataClouds : public ::testing::Test {
 protected:
  // Two views whose cloud lies 5 mm behind the true depth, but for one point of the first object.
  DataClouds() {
    datasets::ViewSet set = handcraft::testing::MakeViewSet(folder_.path());
    set.items.erase(set.items.begin() + 1);
    datasets::OrganisedCloud cloud = handcraft::testing::FlatCloud(8, 6);
    for (Eigen::Vector3f& point : cloud.points) point.z() = 0.605F;
    for (datasets::ObjectView& view : set.items) {
      view.depth = view.instance + "_depth.png";
      perception::WritePng16(folder_ / view.depth, BasicImage<std::uint16_t>(8, 6, 1, 600));
      datasets::WritePcd(folder_ / view.cloud, cloud);
    }
    cloud.points[0].setConstant(std::numeric_limits<float>::quiet_NaN());
    datasets::WritePcd(folder_ / set.items[0].cloud, cloud);
    datasets::WriteViews(set);
  }

  TemporaryDirectory folder_;
};

TEST_F(DataClouds, PrintsATableByClass) {
  const Outcome outcome = RunLine("data clouds " + folder_.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            "class  views  measured  median  90 % within  beyond 20 mm  textured  median there\n"
            "mug        1    95.8 %  5.0 mm       5.0 mm         0.0 %   100.0 %        5.0 mm\n"
            "can        1   100.0 %  5.0 mm       5.0 mm         0.0 %   100.0 %        5.0 mm\n"
            "all        2    97.9 %  5.0 mm       5.0 mm         0.0 %   100.0 %        5.0 mm\n");
}

TEST_F(DataClouds, PrintsJson) {
  const Outcome outcome = RunLine("data clouds --json " + folder_.path().string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["all"]["num_pixels"], 48);
  EXPECT_NEAR(json["classes"]["mug"]["share_measured"], 23.0 / 24.0, 1e-9);
  EXPECT_NEAR(json["classes"]["can"]["median_error_m"], 0.005, 1e-6);
  EXPECT_EQ(json["classes"]["can"]["share_beyond_20_mm"], 0.0);
  EXPECT_EQ(json["classes"]["can"]["share_textured"], 1.0);
  EXPECT_NEAR(json["classes"]["can"]["textured_median_error_m"], 0.005, 1e-6);
}

TEST_F(DataClouds, RefusesAFolderWithoutViews) {
  const Outcome outcome = RunLine("data clouds " + (folder_ / "no").string());
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("No such file"));
}

}  // namespace
}  // namespace handcraft::tools
