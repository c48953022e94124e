// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/feature_analysis/some_analysis.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using features::ParseFeatureSpec;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ColumnsOf, FindsFewerFiltersAndASmallerWindow) {
  const features::FeatureSpec whole = ParseFeatureSpec("filters=edge_0+laplacian,window=3");
  EXPECT_THAT(ColumnsOf(ParseFeatureSpec("filters=laplacian,window=1"), whole), ElementsAre(9));
  EXPECT_THAT(ColumnsOf(ParseFeatureSpec("filters=laplacian+edge_0,window=1"), whole),
              ElementsAre(8, 9));
  EXPECT_EQ(ColumnsOf(whole, whole).size(), 18U);
  EXPECT_THROW(static_cast<void>(ColumnsOf(ParseFeatureSpec("filters=edge_30,window=1"), whole)),
               std::logic_error);
}

TEST(FeatureAnalysis, OfRealPicturesIsWhole) {
  const FeatureAnalysis analysis = AnalyseFeatures(SampleSet(), SmallOptions());
  EXPECT_EQ(analysis.num_samples, 600U);
  EXPECT_EQ(analysis.num_fit_samples + analysis.num_held_out_samples, 600U);
  EXPECT_GE(analysis.num_held_out_objects, 1U);
  EXPECT_GT(analysis.num_fit_objects, analysis.num_held_out_objects);
  EXPECT_EQ(analysis.data_fingerprint, datasets::Fingerprint(SampleSet()));
  EXPECT_EQ(analysis.pca.num_features, 27U);
  ASSERT_EQ(analysis.spectra.size(), 3U);
  EXPECT_EQ(analysis.elimination.order.size(), 3U);

  ASSERT_EQ(analysis.hypotheses.size(), 1U + 3U + 9U + 1U);
  EXPECT_EQ(analysis.hypotheses[0].log_loss, analysis.elimination.all.log_loss);
  EXPECT_EQ(analysis.hypotheses[0].increase.high, 0.0);
  EXPECT_EQ(analysis.hypotheses[1].spec, ParseFeatureSpec("filters=edge_0+edge_90,window=3"));
  EXPECT_EQ(analysis.hypotheses[2].spec.window, 3);
  for (const TestedHypothesis& tested : analysis.hypotheses) {
    EXPECT_GT(tested.log_loss, 0.0) << tested.name;
    EXPECT_NEAR(tested.increase.value, tested.log_loss - analysis.hypotheses[0].log_loss, 1e-12);
  }
  // What elimination proposes costs no more than it was allowed to.
  EXPECT_LE(analysis.hypotheses.back().log_loss, 1.02 * analysis.elimination.all.log_loss + 1e-9);
}

TEST(FeatureAnalysis, IsTheSameForAnyNumberOfThreads) {
  FeatureAnalysisOptions options = SmallOptions();
  const FeatureAnalysis one = AnalyseFeatures(SampleSet(), options);
  options.num_threads = 2;
  const FeatureAnalysis two = AnalyseFeatures(SampleSet(), options);
  EXPECT_EQ(one.pca.eigenvalues, two.pca.eigenvalues);
  EXPECT_EQ(one.elimination.order, two.elimination.order);
  for (std::size_t h = 0; h < one.hypotheses.size(); ++h) {
    EXPECT_EQ(one.hypotheses[h].log_loss, two.hypotheses[h].log_loss);
  }
}

TEST(FeatureAnalysis, NeedsTwoObjects) {
  datasets::LabelledImageSet set = SampleSet();
  set.items.resize(1);
  EXPECT_THROWS_MESSAGE(
      AnalyseFeatures(set, SmallOptions()), Error, HasSubstr("shows one object alone"));
}

TEST(FeatureAnalysisOptions, NameFieldValueAndRule) {
  const auto expect_refused = [](auto field, auto value, const char* message) {
    FeatureAnalysisOptions options = SmallOptions();
    options.*field = value;
    EXPECT_THROWS_MESSAGE(AnalyseFeatures(SampleSet(), options), Error, HasSubstr(message));
  };
  using Options = FeatureAnalysisOptions;
  expect_refused(&Options::num_samples, std::size_t{99}, "num_samples is 99; it must be >= 100");
  expect_refused(&Options::num_classifier_samples, std::size_t{1}, "num_classifier_samples is 1");
  expect_refused(&Options::held_out_share, 1.0, "held_out_share is 1; it must be in (0, 1)");
  expect_refused(&Options::max_loss_increase, -0.1, "max_loss_increase is -0.1");
  expect_refused(&Options::ridge, 0.0, "ridge is 0; it must be a finite number > 0");
  expect_refused(&Options::num_threads, 0, "num_threads is 0");
}

}  // namespace
}  // namespace handcraft::experiments
