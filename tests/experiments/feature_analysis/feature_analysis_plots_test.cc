// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_plots.h"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/feature_analysis/some_analysis.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Ranks, GiveOneToTheLargest) {
  EXPECT_THAT(RanksOf({0.2, 0.7, 0.1}), ElementsAre(2, 1, 3));
  EXPECT_THAT(RanksOf({0.5, 0.5}), ElementsAre(1, 2));
  EXPECT_THAT(UsefulnessRanks({.all = {}, .steps = {}, .order = {2, 0, 1}}), ElementsAre(2, 1, 3));
}

TEST(FeatureAnalysisPlots, EigenvaluesAreOnALogarithmicAxis) {
  FeatureAnalysis analysis = HandFilledAnalysis();
  const std::string svg = PlotEigenvalues(analysis.spectra).ToFileText();
  EXPECT_THAT(
      svg, AllOf(HasSubstr("1e-2"), HasSubstr("raw features"), HasSubstr("standardised features")));
  // What is rounding is no point of the line.
  analysis.spectra.resize(1);
  analysis.spectra[0].eigenvalues = {1.0, 1e-20};
  EXPECT_THAT(PlotEigenvalues(analysis.spectra).ToFileText(), Not(HasSubstr("1e-20")));
}

TEST(FeatureAnalysisPlots, FirstComponentHasABarAFeature) {
  const FeatureAnalysis analysis = HandFilledAnalysis();
  const std::string svg =
      PlotFirstComponent(analysis.spectra[1], analysis.options.spec).ToFileText();
  EXPECT_EQ(Count(svg, "<rect"), 2U);
  EXPECT_THAT(svg, HasSubstr("a grid line every 2"));
}

TEST(FeatureAnalysisPlots, RankingsNameEveryFilterOnBothSides) {
  const std::string svg = PlotRankings(HandFilledAnalysis()).ToFileText();
  EXPECT_EQ(Count(svg, ">laws_LL<"), 2U);
  EXPECT_EQ(Count(svg, ">edge_0<"), 2U);
  EXPECT_EQ(Count(svg, "<circle"), 6U);  // two filters, three columns
  EXPECT_THAT(svg, HasSubstr(">usefulness<"));
}

TEST(FeatureAnalysisPlots, EliminationHasAPointAStepAndItsInterval) {
  FeatureAnalysis analysis = HandFilledAnalysis();
  EXPECT_EQ(Count(PlotElimination(analysis).ToFileText(), "<circle"), 2U);
  analysis.elimination.steps[0].increase.low = std::numeric_limits<double>::quiet_NaN();
  analysis.elimination.steps[0].increase.high = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Count(PlotElimination(analysis).ToFileText(), "<circle"), 2U);
  analysis.elimination.steps.clear();
  analysis.elimination.order = {0};
  EXPECT_EQ(Count(PlotElimination(analysis).ToFileText(), "<circle"), 1U);
}

}  // namespace
}  // namespace handcraft::experiments
