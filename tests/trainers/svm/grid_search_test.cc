// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/grid_search.h"

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"
#include "tests/trainers/svm/drawn_classes.h"

namespace handcraft::svm {
namespace {

using ::testing::HasSubstr;

using features::SimilarityType;

TEST(Grid, CombinesOnlyWhatAKernelReads) {
  const Grid grid{
      .kernels = {SimilarityType::kLinear, SimilarityType::kPolynomial, SimilarityType::kRbf},
      .degrees = {2, 3},
      .gammas = {0.1, 0.2, 0.3},
      .coef0s = {0.0, 1.0},
      .penalties = {1.0, 10.0}};
  const std::vector<Options> combinations = grid.Combinations({.num_threads = 2});
  ASSERT_EQ(combinations.size(), 2U + 2U * 3U * 2U * 2U + 3U * 2U);
  EXPECT_EQ(combinations[0].kernel, SimilarityType::kLinear);
  EXPECT_EQ(combinations[1].penalty, 10.0);
  EXPECT_EQ(combinations[2].degree, 2);
  EXPECT_EQ(combinations.back().kernel, SimilarityType::kRbf);
  EXPECT_EQ(combinations.back().gamma, 0.3);
  EXPECT_EQ(combinations.back().num_threads, 2);
}

TEST(Grid, RefusesEmptyListsAndBadValues) {
  EXPECT_THROWS_MESSAGE((Grid{.penalties = {}}.Combinations({})),
                        Error,
                        HasSubstr("svm::Grid.penalties.size is 0; it must be at least 1"));
  EXPECT_THROWS_MESSAGE((Grid{.penalties = {1.0, -1.0}}.Combinations({})),
                        Error,
                        HasSubstr("svm::Options.penalty is -1; it must be above 0"));
}

TEST(SearchGrid, FindsTheMostCorrectAndOfEqualsTheFirst) {
  const auto drawn =
      DrawClasses<double>({.num_classes = 3, .samples_per_class = 15, .spread = 0.5}, 31);
  const Samples samples = PrepareSamples(drawn.Matrix(), drawn.classes, {});
  const SampleMatrix products = ComputeInnerProducts(samples, 1);
  const std::vector<std::uint32_t> folds = LeaveOneOutFolds(45);
  const Grid grid{
      .kernels = {SimilarityType::kRbf}, .gammas = {1e-6, 0.3, 0.3, 1e4}, .penalties = {1.0}};
  const GridSearch search = SearchGrid(products, samples, folds, grid);
  ASSERT_EQ(search.points.size(), 4U);
  EXPECT_EQ(search.best, 1U);
  for (const GridPoint& point : search.points) {
    const SampleMatrix gram = ComputeGram(products, point.options.SimilarityFor(5), samples, 1);
    EXPECT_EQ(CrossValidate(gram, samples, folds, point.options).predicted,
              point.validation.predicted);
  }
}

TEST(SearchGridOfRows, IsTheSameFromATable) {
  const auto drawn = DrawClasses<float>({.num_classes = 3, .samples_per_class = 8}, 16);
  const std::vector<std::uint32_t> folds = StratifiedFolds(drawn.classes, 4);
  const Options options{.standardize = true};
  const Grid grid{.coef0s = {0.0, 1.0}};
  const Samples samples =
      PrepareSamples(drawn.Matrix(), drawn.classes, FitNormaliser(drawn.Matrix()));
  const GridSearch search = SearchGridOfRows(drawn.Matrix(), drawn.classes, folds, grid, options);
  const GridSearch other =
      SearchGrid(ComputeInnerProducts(samples, 1), samples, folds, grid, options);
  ASSERT_EQ(search.points.size(), 2U);
  EXPECT_EQ(search.points[1].validation.margins, other.points[1].validation.margins);
}

}  // namespace
}  // namespace handcraft::svm
