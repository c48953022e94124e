// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_tables.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/feature_analysis/some_analysis.h"

namespace handcraft::experiments {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

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

TEST(FeatureAnalysisTables, GiveMachinesExactNumbers) {
  const FeatureAnalysis analysis = HandFilledAnalysis();
  EXPECT_EQ(CsvText(FilterTable(analysis, Reader::kMachines)),
            "filter,energy_share_raw,energy_rank_raw,energy_share_standard,energy_rank_standard,"
            "usefulness_rank,log_loss_without\n"
            "laws_LL,0.99,1,0.4,2,2,0.52\nedge_0,0.01,2,0.6,1,1,\n");
  EXPECT_EQ(CsvText(EliminationTable(analysis)),
            "filters_left,removed,num_features,log_loss,auc,increase,increase_low,increase_high\n"
            "1,laws_LL,1,0.52,0.79,0.02,-0.01,0.05\n");
  EXPECT_EQ(CsvText(EigenvalueTable(analysis)), "component,raw,standard\n1,100,1.5\n2,1,0.5\n");
  EXPECT_EQ(CsvText(PositionTable(analysis, Reader::kMachines)),
            "position,energy_share_raw,energy_rank_raw,energy_share_standard,energy_rank_standard\n"
            "\"(0,0)\",1,1,1,1\n");
  EXPECT_THAT(CsvText(HypothesisTable(analysis, Reader::kMachines)),
              HasSubstr("\n\"energy, raw, 1: filters\",\"filters=laws_LL,window=1,energy=square,"
                        "scales=none\",1,0.61,0.7,0.11,0.02,0.2\n"));
}

TEST(FeatureAnalysisTables, RoundNumbersForPeople) {
  const FeatureAnalysis analysis = HandFilledAnalysis();
  EXPECT_THAT(CsvText(FilterTable(analysis, Reader::kPeople)), HasSubstr("99.00 %"));
  EXPECT_THAT(HypothesisTable(analysis, Reader::kPeople).rows.back(),
              ElementsAre("energy, raw, 1: filters",
                          "laws_LL",
                          "1×1",
                          "1",
                          "0.6100",
                          "0.700",
                          "+0.1100 [+0.0200, +0.2000]"));
}

}  // namespace
}  // namespace handcraft::experiments
