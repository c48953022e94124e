// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/search_space_figures.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::experiments {
namespace {

using ::testing::IsEmpty;

ImageScore Scored(SearchOutcome search) {
  ImageScore score;
  score.search = std::move(search);
  return score;
}

TEST(SearchSpaceOf, IsTheMeanWhereAStageNotReachedCountsNothing) {
  const std::vector<ImageScore> images = {
      Scored({.has_region = true,
              .stages = {{"picture", 100, 0.0}, {"crop", 40, 1.0}, {"scored", 20, 3.0}}}),
      Scored({.has_region = false, .stages = {{"picture", 100, 0.0}, {"crop", 10, 2.0}}})};
  const SearchSpaceFigures figures = SearchSpaceOf(images);
  EXPECT_EQ(figures.num_images_without_region, 1U);
  ASSERT_EQ(figures.stages.size(), 3U);
  EXPECT_EQ(figures.stages[0].num_pixels, 100.0);
  EXPECT_EQ(figures.stages[1].num_pixels, 25.0);
  EXPECT_EQ(figures.stages[1].time_ms, 1.5);
  EXPECT_EQ(figures.stages[2].stage, "scored");
  EXPECT_EQ(figures.stages[2].num_pixels, 10.0);
}

TEST(SearchSpaceOf, HasNoStagesWhereNoRegionWasLookedFor) {
  const std::vector<ImageScore> images(3);
  EXPECT_THAT(SearchSpaceOf(images).stages, IsEmpty());
  EXPECT_EQ(SearchSpaceOf(images).num_images_without_region, 0U);
}

TEST(Pooled, IsTheMeanOverRepetitions) {
  const std::vector<SearchSpaceFigures> repetitions = {
      {.num_images_without_region = 1,
       .stages = {{.stage = "crop", .num_pixels = 10.0, .time_ms = 1.0}}},
      {.num_images_without_region = 2,
       .stages = {{.stage = "crop", .num_pixels = 30.0, .time_ms = 2.0}}}};
  const SearchSpaceFigures pooled = Pooled(repetitions);
  EXPECT_EQ(pooled.num_images_without_region, 3U);
  ASSERT_EQ(pooled.stages.size(), 1U);
  EXPECT_EQ(pooled.stages[0].num_pixels, 20.0);
  EXPECT_EQ(pooled.stages[0].time_ms, 1.5);
  EXPECT_THAT(Pooled({}).stages, IsEmpty());
}

}  // namespace
}  // namespace handcraft::experiments
