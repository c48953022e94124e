// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/feature_spec.h"

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::features {
namespace {

using ::testing::HasSubstr;

TEST(FeatureSpec, PresetsHaveTheSizesOfTheirNames) {
  EXPECT_EQ(ParseFeatureSpec("all500").NumFeatures(), 500);
  EXPECT_EQ(ParseFeatureSpec("edges150").NumFeatures(), 150);
  EXPECT_EQ(ParseFeatureSpec("window180").NumFeatures(), 180);
  EXPECT_EQ(ParseFeatureSpec("edges54").NumFeatures(), 54);
  EXPECT_EQ(ParseFeatureSpec("saxena459").NumFeatures(), 459);
}

TEST(FeatureSpec, OnlyChromaNeedsColour) {
  EXPECT_FALSE(ParseFeatureSpec("all500").NeedsColour());
  EXPECT_TRUE(ParseFeatureSpec("saxena459").NeedsColour());
}

TEST(FeatureSpec, TakesAnySubset) {
  const FeatureSpec spec =
      ParseFeatureSpec("filters=laplacian+edges+sobel1_5,window=3,energy=log,scales=2+5");
  EXPECT_EQ(spec.NumFilters(), 8);
  EXPECT_EQ(spec.filters.front(), Filter::kLaplacian);
  EXPECT_EQ(spec.window, 3);
  EXPECT_EQ(spec.energy, Energy::kLog);
  EXPECT_EQ(spec.scales, (std::vector<int>{2, 5}));
  EXPECT_EQ(spec.NumFeatures(), 8 * (9 + 2));
}

TEST(FeatureSpec, PairsChangeAPreset) {
  const FeatureSpec spec = ParseFeatureSpec("saxena459,energy=abs,scales=none");
  EXPECT_EQ(spec.energy, Energy::kAbs);
  EXPECT_EQ(spec.NumFeatures(), 425);
}

TEST(FeatureSpec, CanonicalTextReadsBack) {
  for (const char* text : {"all500", "edges54,energy=abs", "saxena459", "filters=cr_LL,window=1"}) {
    const FeatureSpec spec = ParseFeatureSpec(text);
    EXPECT_EQ(ParseFeatureSpec(ToString(spec)), spec) << ToString(spec);
  }
  EXPECT_EQ(ToString(ParseFeatureSpec("filters=laplacian,window=1,energy=log")),
            "filters=laplacian,window=1,energy=log,scales=none");
}

TEST(FeatureSpec, NamesFeatures) {
  const FeatureSpec spec = ParseFeatureSpec("saxena459");
  EXPECT_EQ(FeatureName(spec, 0), "laws_LL@(-2,-2)");
  EXPECT_EQ(FeatureName(spec, 17 * 5 + 9), "edge_0@(-2,-1)");
  EXPECT_EQ(FeatureName(spec, 458), "cr_LL@1/9");
}

TEST(FeatureSpec, SaysWhichWordIsWrong) {
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all501"), Error, HasSubstr("unknown preset 'all501'"));
  EXPECT_THROWS_MESSAGE(
      ParseFeatureSpec("filters=edge_45"), Error, HasSubstr("unknown filter 'edge_45'"));
  EXPECT_THROWS_MESSAGE(
      ParseFeatureSpec("all500,energy=cube"), Error, HasSubstr("square, abs, log"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all500,size=5"), Error, HasSubstr("unknown key 'size'"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all500,window=4"), Error, HasSubstr("1, 3 or 5"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all500,window=five"), Error, HasSubstr("'five'"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all500,window="), Error, HasSubstr("not a whole number"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("filters=edges+edge_0"), Error, HasSubstr("twice"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all500,scales=9+3"), Error, HasSubstr("ascending"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("all500,scales=17"), Error, HasSubstr("2 to 16"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec("window=3"), Error, HasSubstr("no filters"));
  EXPECT_THROWS_MESSAGE(ParseFeatureSpec(""), Error, HasSubstr("no filters"));
}

}  // namespace
}  // namespace handcraft::features
