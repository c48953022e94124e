// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/cell_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

CellSettings Applied(const std::vector<Setting>& list) {
  CellSettings settings;
  for (const Setting& setting : list) ApplySetting(setting, settings);
  return settings;
}

TEST(ApplySetting, ReadsEveryKey) {
  const CellSettings settings = Applied({{"features", "edges54"},
                                         {"energy", "abs"},
                                         {"window", "1"},
                                         {"ridge", "0.25"},
                                         {"training_share", "0.2"},
                                         {"samples", "123"},
                                         {"training_scales", "1+0.5"},
                                         {"classifier", "lda"},
                                         {"region", "object"},
                                         {"shrinkage", "0.25"},
                                         {"prior", "0.125"},
                                         {"bad_per_good", "3"}});
  EXPECT_EQ(settings.features, "edges54");
  EXPECT_EQ(settings.energy, features::Energy::kAbs);
  EXPECT_EQ(settings.window, 1);
  EXPECT_EQ(settings.ridge, 0.25);
  EXPECT_EQ(settings.training_share, 0.2);
  EXPECT_EQ(settings.samples, 123U);
  EXPECT_THAT(settings.training_scales, ::testing::ElementsAre(1.0, 0.5));
  EXPECT_EQ(settings.classifier, Classifier::kLda);
  EXPECT_EQ(settings.region, TestRegion::kObject);
  EXPECT_EQ(settings.shrinkage, 0.25);
  EXPECT_EQ(settings.shrinkage_rule, lda::ShrinkageRule::kFixed);
  EXPECT_EQ(settings.prior, 0.125);
  EXPECT_EQ(settings.bad_per_good, 3.0);
}

TEST(ApplySetting, LeavesTheOthersAsTheyAre) {
  CellSettings settings = Applied({{"samples", "7"}});
  ApplySetting({"ridge", "1"}, settings);
  EXPECT_EQ(settings.samples, 7U);
  EXPECT_EQ(settings.training_share, CellSettings{}.training_share);
}

TEST(ApplySetting, TakesShrinkageFromTheDataWhereItIsAuto) {
  const CellSettings settings = Applied({{"shrinkage", "0.5"}, {"shrinkage", "auto"}});
  EXPECT_EQ(settings.shrinkage_rule, lda::ShrinkageRule::kLedoitWolf);
  EXPECT_EQ(settings.shrinkage, 0.0);
  EXPECT_EQ(Applied({{"shrinkage", "auto"}, {"shrinkage", "1"}}).shrinkage_rule,
            lda::ShrinkageRule::kFixed);
}

TEST(ApplySetting, NamesKeyValueAndRule) {
  for (const char* shrinkage : {"-0.1", "1.5", "nan", "some"}) {
    EXPECT_THROWS_MESSAGE(
        Applied({{"shrinkage", shrinkage}}), Error, HasSubstr("a number in [0, 1], or auto"));
  }
  EXPECT_THROWS_MESSAGE(Applied({{"prior", "1"}}), Error, HasSubstr("in [0, 1)"));
  EXPECT_THROWS_MESSAGE(Applied({{"prior", "auto"}}), Error, HasSubstr("in [0, 1)"));
  EXPECT_THROWS_MESSAGE(Applied({{"ridge", "-1"}}),
                        Error,
                        AllOf(HasSubstr("ridge is \"-1\""), HasSubstr("from 0 on")));
  EXPECT_THROWS_MESSAGE(Applied({{"ridge", "nan"}}), Error, HasSubstr("ridge"));
  EXPECT_THROWS_MESSAGE(Applied({{"ridge", "inf"}}), Error, HasSubstr("ridge"));
  EXPECT_THROWS_MESSAGE(Applied({{"training_share", "0"}}), Error, HasSubstr("(0, 1]"));
  EXPECT_THROWS_MESSAGE(Applied({{"training_share", "1.5"}}), Error, HasSubstr("(0, 1]"));
  EXPECT_THROWS_MESSAGE(Applied({{"samples", "-3"}}), Error, HasSubstr("whole number"));
  EXPECT_THROWS_MESSAGE(Applied({{"samples", "2.5"}}), Error, HasSubstr("whole number"));
  EXPECT_THROWS_MESSAGE(Applied({{"bad_per_good", ""}}), Error, HasSubstr("above 0"));
  for (const char* scales : {"", "1+", "1+1", "0.05", "1+x", "11"}) {
    EXPECT_THROWS_MESSAGE(
        Applied({{"training_scales", scales}}), Error, HasSubstr("such as 1+0.5+1.5"));
  }
  EXPECT_THROWS_MESSAGE(Applied({{"window", "4"}}), Error, HasSubstr("1, 3 or 5"));
  EXPECT_THROWS_MESSAGE(Applied({{"energy", "cube"}}), Error, HasSubstr("square, abs, log"));
  EXPECT_THROWS_MESSAGE(Applied({{"classifier", "svm"}}), Error, HasSubstr("logistic or lda"));
  EXPECT_THROWS_MESSAGE(Applied({{"region", "table"}}), Error, HasSubstr("picture or object"));
  EXPECT_THROWS_MESSAGE(Applied({{"features", "few"}}), Error, HasSubstr("few"));
  EXPECT_THROWS_MESSAGE(
      Applied({{"sample", "1"}}),
      Error,
      AllOf(HasSubstr("\"sample\" is no setting"), HasSubstr("features, energy, window")));
}

TEST(SettingKeys, AreAllUnderstood) {
  for (const std::string_view key : SettingKeys()) {
    EXPECT_THROWS_MESSAGE(
        Applied({{std::string(key), "?"}}), Error, Not(HasSubstr("is no setting")));
  }
}

TEST(SpecOf, ChangesEnergyAndWindowOfTheFeatures) {
  EXPECT_EQ(SpecOf(Applied({{"features", "all500,energy=abs"}})),
            features::ParseFeatureSpec("all500,energy=abs"));
  EXPECT_EQ(SpecOf(Applied({{"features", "all500"}, {"energy", "log"}, {"window", "3"}})),
            features::ParseFeatureSpec("all500,energy=log,window=3"));
}

TEST(SpecOf, LetsLaterFeaturesUndoWhatTheyNameThemselves) {
  EXPECT_EQ(SpecOf(Applied({{"energy", "log"}, {"features", "edges54,energy=square"}})),
            features::ParseFeatureSpec("edges54,energy=square"));
  EXPECT_EQ(SpecOf(Applied({{"energy", "log"}, {"features", "edges54"}})),
            features::ParseFeatureSpec("edges54,energy=log"));
  EXPECT_EQ(SpecOf(Applied({{"window", "1"}, {"features", "window180"}})),
            features::ParseFeatureSpec("window180"));
}

}  // namespace
}  // namespace handcraft::experiments
