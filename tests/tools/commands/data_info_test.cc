// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/demonstration_set.h"
#include "datasets/formats/hold_set.h"
#include "datasets/formats/labelled_image_set.h"
#include "tests/datasets/small_demonstration_set.h"
#include "tests/datasets/small_view_set.h"
#include "tests/tools/support/generated_data.h"
#include "tests/tools/support/run.h"

namespace handcraft::tools {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::RunArgs;

using DataInfo = testing::ImageSetTest;

TEST_F(DataInfo, CountsSplits) {
  const Outcome outcome = RunArgs({"data", "info", set_.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("split  class  images  instances  good %"),
                    HasSubstr("test   disc        1          1"),
                    HasSubstr("test   (all)       2          2"),
                    HasSubstr("train  bar         2          2"),
                    HasSubstr("train  (all)       4          4"),
                    HasSubstr("sizes [px]   64x48 (6)"),
                    HasSubstr("licence      CC0-1.0"),
                    HasSubstr("fingerprint  ")));
}

TEST_F(DataInfo, TellsMachinesTheSame) {
  const auto json = nlohmann::json::parse(RunArgs({"data", "info", set_.string(), "--json"}).out);
  EXPECT_EQ(json["kind"], "labelled image set");
  EXPECT_EQ(json["num_images"], 6);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(datasets::ReadLabelledImageSet(set_)));
  ASSERT_EQ(json["splits"].size(), 2U);
  EXPECT_EQ(json["splits"][1]["name"], "train");
  EXPECT_EQ(json["splits"][1]["num_pixels"], 4 * 64 * 48);
  EXPECT_EQ(json["splits"][1]["classes"]["bar"]["num_pixels"], 2 * 64 * 48);
  EXPECT_EQ(json["sizes"]["64x48"], 6);
  EXPECT_GT(json["splits"][1]["num_bad_pixels"], json["splits"][1]["num_good_pixels"]);
}

TEST_F(DataInfo, DescribesViewSets) {
  const std::filesystem::path root = folder_ / "views";
  std::filesystem::create_directory(root);
  datasets::WriteViews(handcraft::testing::MakeViewSet(root));
  const Outcome outcome = RunArgs({"data", "info", root.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr("View set "),
            HasSubstr("split  class  views  instances  angles  object %  clouds  measured"),
            HasSubstr("test   can        1          1       1     50.00       1      100.00"),
            HasSubstr("train  mug        2          1       1     50.00       1      100.00"),
            HasSubstr("sizes [px]   8x6 (3)"),
            HasSubstr("licence      CC0-1.0")));
  const auto json = nlohmann::json::parse(RunArgs({"data", "info", root.string(), "--json"}).out);
  EXPECT_EQ(json["kind"], "view set");
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(datasets::ReadViewSet(root)));
  EXPECT_EQ(json["splits"][1]["classes"]["mug"]["num_images_without_angle"], 1);
  EXPECT_EQ(json["splits"][1]["classes"]["mug"]["num_object_pixels"], 48);
  EXPECT_EQ(json["splits"][1]["classes"]["mug"]["num_measured_object_pixels"], 24);
  EXPECT_FALSE(json.contains("demonstrations"));
}

TEST_F(DataInfo, CountsPosesBesideViews) {
  const std::filesystem::path root = folder_ / "shown";
  std::filesystem::create_directory(root);
  const datasets::DemonstrationSet poses = handcraft::testing::MakeDemonstrationSet(root);
  datasets::WriteHolds(
      {.root = root,
       .items = {{"can", "can", "can_0.png", {}, {}}, {"can", "can", "can_0.png", {}, {}}}});
  const Outcome outcome = RunArgs({"data", "info", root.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("class  demonstrations  instances  views  least a view  most a view"),
                    HasSubstr("mug                 2          1      2             1            1"),
                    HasSubstr("(all)               3          2      3             1            1"),
                    HasSubstr("frame        base, of the grasp_centre"),
                    HasSubstr("can        2          1      1             2            2")));
  const auto json = nlohmann::json::parse(RunArgs({"data", "info", root.string(), "--json"}).out);
  EXPECT_EQ(json["demonstrations"]["num_poses"], 3);
  EXPECT_EQ(json["demonstrations"]["fingerprint"], datasets::Fingerprint(poses));
  EXPECT_EQ(json["demonstrations"]["classes"]["mug"]["num_views"], 2);
  EXPECT_EQ(json["holds"]["most_per_view"], 2);
  EXPECT_EQ(json["holds"]["end_effector"], "grasp_centre");
}

TEST_F(DataInfo, NamesAMissingFolder) {
  const Outcome outcome = RunArgs({"data", "info", "no/such/folder"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("handcraft: error: no/such/folder"));
}

}  // namespace
}  // namespace handcraft::tools
