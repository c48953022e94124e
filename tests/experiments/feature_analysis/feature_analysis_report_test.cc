// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "experiments/feature_analysis/feature_analysis_tables.h"
#include "tests/experiments/feature_analysis/some_analysis.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Key;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

TEST(PositionNames, AreWindowPixelsThenScales) {
  EXPECT_THAT(PositionNames(features::ParseFeatureSpec("filters=edge_0,window=1,scales=3+9")),
              ElementsAre("(0,0)", "1/3", "1/9"));
}

TEST(KeptFiltersText, NamesTheFewer) {
  const auto whole = features::ParseFeatureSpec("filters=edges");
  const auto text = [&whole](const std::string& filters) {
    return KeptFiltersText(features::ParseFeatureSpec("filters=" + filters), whole);
  };
  EXPECT_EQ(text("edges"), "all 6");
  EXPECT_EQ(text("edge_150+edge_0+edge_30"), "edge_0, edge_30, edge_150");
  EXPECT_EQ(text("edge_0+edge_30+edge_60+edge_90"), "all but edge_120, edge_150");
}

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

TEST(FeatureAnalysisReport, WritesTablesForMachines) {
  const auto files = FeatureAnalysisFiles(HandFilledAnalysis(), "mugs");
  EXPECT_EQ(files.at("filters.csv"),
            "filter,energy_share_raw,energy_rank_raw,energy_share_standard,energy_rank_standard,"
            "usefulness_rank,log_loss_without\n"
            "laws_LL,0.99,1,0.4,2,2,0.52\nedge_0,0.01,2,0.6,1,1,\n");
  EXPECT_EQ(files.at("elimination.csv"),
            "filters_left,removed,num_features,log_loss,auc,increase,increase_low,increase_high\n"
            "1,laws_LL,1,0.52,0.79,0.02,-0.01,0.05\n");
  EXPECT_EQ(files.at("eigenvalues.csv"), "component,raw,standard\n1,100,1.5\n2,1,0.5\n");
  EXPECT_EQ(files.at("positions.csv"),
            "position,energy_share_raw,energy_rank_raw,energy_share_standard,energy_rank_standard\n"
            "\"(0,0)\",1,1,1,1\n");
  EXPECT_THAT(files.at("hypotheses.csv"),
              HasSubstr("\n\"energy, raw, 1: filters\",\"filters=laws_LL,window=1,energy=square,"
                        "scales=none\",1,0.61,0.7,0.11,0.02,0.2\n"));
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
