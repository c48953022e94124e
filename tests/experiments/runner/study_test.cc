// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/experiments/runner/small_study.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(CanonicalLines, NamesEverythingThatResultsDependOn) {
  EXPECT_THAT(CanonicalLines(testing::SmallStudy("data")),
              ElementsAre("data.train = a folder",
                          "split = instance",
                          "seed = 1",
                          "repetitions = 2",
                          "evaluation.pixels_per_image = 40",
                          "evaluation.resamples = 40",
                          "settings.samples = 200",
                          "settings.training_share = 0.5",
                          "method laplacian",
                          "method laplacian.features = filters=laplacian,window=1,energy=log",
                          "method edge",
                          "method edge.features = filters=edge_0,window=1,energy=log",
                          "grid.ridge = 0.5; 2"));
}

TEST(CanonicalLines, PinWhatIsMade) {
  Study study = testing::SmallStudy("data");
  study.split = StudySplit::kClass;
  study.test = DataSource{.family = "novel", .num_images = 12, .seed = 5};
  const std::vector<std::string> lines = CanonicalLines(study);
  EXPECT_THAT(lines, Contains("data.test.made = novel"));
  EXPECT_THAT(lines, Contains("data.test.images = 12"));
  EXPECT_THAT(lines, Contains("data.test.seed = 5"));
  EXPECT_THAT(lines, Contains("split = class"));
}

TEST(CanonicalLines, DoNotDependOnWordsAndPlaces) {
  const Study study = testing::SmallStudy("data");
  Study other = testing::SmallStudy("elsewhere");
  other.title = "Another";
  other.question = "?";
  other.claim = Claim{"here", 1.0};
  EXPECT_EQ(CanonicalLines(other), CanonicalLines(study));
}

TEST(KeepMethods, LeavesOutTheOthers) {
  Study study = testing::SmallStudy("data");
  KeepMethods(std::vector<std::string>{"edge", "laplacian"}, study);
  EXPECT_EQ(study.methods.size(), 2U);
  KeepMethods(std::vector<std::string>{"laplacian"}, study);
  ASSERT_EQ(study.methods.size(), 1U);
  EXPECT_EQ(study.methods[0].name, "laplacian");
}

TEST(KeepMethods, KnowsTheNamesAndNeedsTheBaseline) {
  Study study = testing::SmallStudy("data");
  EXPECT_THROWS_MESSAGE(KeepMethods(std::vector<std::string>{"laplacian", "sobel"}, study),
                        Error,
                        AllOf(HasSubstr("no method \"sobel\""), HasSubstr("laplacian, edge")));
  EXPECT_THROWS_MESSAGE(KeepMethods(std::vector<std::string>{"edge"}, study),
                        Error,
                        HasSubstr("compared with laplacian"));
}

}  // namespace
}  // namespace handcraft::experiments
