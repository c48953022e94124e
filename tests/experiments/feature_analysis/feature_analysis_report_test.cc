// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/experiments/feature_analysis/some_analysis.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

TEST(FeatureAnalysisReport, HasTheseFiles) {
  EXPECT_THAT(FeatureAnalysisFiles(HandFilledAnalysis(), "mugs"),
              UnorderedElementsAre(Key("summary.md"),
                                   Key("report.html"),
                                   Key("results.json"),
                                   Key("filters.csv"),
                                   Key("positions.csv"),
                                   Key("eigenvalues.csv"),
                                   Key("elimination.csv"),
                                   Key("hypotheses.csv"),
                                   Key("eigenvalues.svg"),
                                   Key("rankings.svg"),
                                   Key("elimination.svg"),
                                   Key("first_eigenvector_raw.svg"),
                                   Key("first_eigenvector_standard.svg")));
}

TEST(FeatureAnalysisReport, WritesJson) {
  const auto json =
      nlohmann::json::parse(FeatureAnalysisFiles(HandFilledAnalysis(), "mugs").at("results.json"));
  EXPECT_EQ(json["num_held_out_objects"], 3);
  EXPECT_EQ(json["energy"]["raw"]["num_components_99"], 1);
  EXPECT_EQ(json["elimination"]["order"][1], "edge_0");
  EXPECT_EQ(json["hypotheses"][1]["log_loss_increase_interval"][1], 0.2);
  EXPECT_EQ(json["options"]["min_filter_share"], "0.01");
}

TEST(FeatureAnalysisReport, IsReadableAndNeedsNothingFromOutside) {
  const auto files = FeatureAnalysisFiles(HandFilledAnalysis(), "mugs & cups");
  EXPECT_THAT(
      files.at("summary.md"),
      AllOf(HasSubstr("2 features"),
            HasSubstr("30 pixels of 3 other objects"),
            HasSubstr("| energy, raw, 1: filters | laws_LL | 1×1 | 1 | 0.6100 | 0.700 | +0.1100 "
                      "[+0.0200, +0.2000] |"),
            HasSubstr("| all features | all 2 | 1×1 |"),
            HasSubstr("| edge_0 | 1.00 % | 2 | 60.00 % | 1 | 1 | – |")));
  const std::string& page = files.at("report.html");
  EXPECT_THAT(page,
              AllOf(HasSubstr("mugs &amp; cups"),
                    HasSubstr("<svg"),
                    HasSubstr(">laws_LL</td>"),
                    Not(HasSubstr("http")),
                    Not(HasSubstr("<script"))));
}

}  // namespace
}  // namespace handcraft::experiments
