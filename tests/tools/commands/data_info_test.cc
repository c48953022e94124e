// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "datasets/formats/labelled_image_set.h"
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
  EXPECT_EQ(json["num_images"], 6);
  EXPECT_EQ(json["fingerprint"], datasets::Fingerprint(datasets::ReadLabelledImageSet(set_)));
  ASSERT_EQ(json["splits"].size(), 2U);
  EXPECT_EQ(json["splits"][1]["name"], "train");
  EXPECT_EQ(json["splits"][1]["num_pixels"], 4 * 64 * 48);
  EXPECT_EQ(json["splits"][1]["classes"]["bar"]["num_pixels"], 2 * 64 * 48);
  EXPECT_EQ(json["sizes"]["64x48"], 6);
  EXPECT_GT(json["splits"][1]["num_bad_pixels"], json["splits"][1]["num_good_pixels"]);
}

TEST_F(DataInfo, NamesAMissingFolder) {
  const Outcome outcome = RunArgs({"data", "info", "no/such/folder"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("handcraft: error: no/such/folder"));
}

}  // namespace
}  // namespace handcraft::tools
