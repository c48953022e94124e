// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/svm_fit.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "lib/core/fields.h"
#include "lib/core/rng.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::tools {
namespace {

using features::SimilarityType;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A disc of one class in a ring of the other: no line tells them apart.
struct DiscAndRing {
  std::vector<double> values;
  std::vector<std::uint32_t> classes;

  explicit DiscAndRing(std::size_t num_samples) {
    Rng rng(5);
    for (std::size_t i = 0; i < num_samples; ++i) {
      const double angle = 6.28 * rng.Uniform();
      const double radius = rng.Uniform() + (i % 2 == 0 ? 0.0 : 2.0);
      values.push_back(radius * std::cos(angle));
      values.push_back(radius * std::sin(angle));
      classes.push_back(static_cast<std::uint32_t>(i % 2));
    }
  }
  [[nodiscard]] DesignMatrix<double> Matrix() const {
    return {.data = values.data(), .num_samples = classes.size(), .num_features = 2, .stride = 2};
  }
};

TEST(ParseGrid, TakesListsAndKeepsTheRest) {
  const svm::Grid grid =
      ParseGrid({"kernel=linear,rbf", "C=0.1,1,10", "gamma=0"}, {.degree = 2, .coef0 = 1.0});
  EXPECT_THAT(grid.kernels, ElementsAre(SimilarityType::kLinear, SimilarityType::kRbf));
  EXPECT_THAT(grid.penalties, ElementsAre(0.1, 1.0, 10.0));
  EXPECT_THAT(grid.gammas, ElementsAre(0.0));
  EXPECT_THAT(grid.degrees, ElementsAre(2));
  EXPECT_THAT(grid.coef0s, ElementsAre(1.0));
}

TEST(ParseGrid, RefusesWhatIsNoListOfValues) {
  const struct {
    std::vector<std::string> search;
    const char* message;
  } cases[] = {
      {{"C"}, "'C' given; it must be NAME=VALUE"},
      {{"nu=0.5"}, "'nu' given; it must be NAME=VALUE"},
      {{"C="}, "'' given; it must be NAME=VALUE"},
      {{"C=1,"}, "'1,' given; it must be NAME=VALUE"},
      {{"C=1,,2"}, "it must be a number"},
      {{"C=1,-1"}, "-1 given; it must be above 0"},
      {{"degree=2.5"}, "2.5 given; it must be a whole number"},
      {{"kernel=cubic"}, "kernel cubic given; it must be linear, poly or rbf"},
      {{"C=1", "C=2"}, "C given twice"},
  };
  for (const auto& [search, message] : cases) {
    EXPECT_THROWS_MESSAGE(static_cast<void>(ParseGrid(search, {})), Error, HasSubstr(message));
  }
}

TEST(FitSvm, TakesTheOptionsThatHeldOutSamplesPrefer) {
  const DiscAndRing drawn(40);
  const SvmFit fit = FitSvm(drawn.Matrix(),
                            drawn.classes,
                            {.svm = {.kernel = SimilarityType::kLinear},
                             .search = {"kernel=linear,rbf", "gamma=1"},
                             .num_folds = 4});
  EXPECT_EQ(fit.options.kernel, SimilarityType::kRbf);
  EXPECT_EQ(fit.num_tried, 2U);
  ASSERT_TRUE(fit.held_out);
  EXPECT_EQ(fit.held_out->accuracy, 1.0);
  // The model is the one that these options give on all samples.
  const svm::Result direct = svm::TrainSvm(drawn.Matrix(), drawn.classes, fit.options);
  EXPECT_EQ(fit.result.model.dual_coefficients, direct.model.dual_coefficients);
}

TEST(FitSvm, WithoutFoldsTrainsWithTheOptionsGiven) {
  const DiscAndRing drawn(20);
  const SvmFit fit = FitSvm(drawn.Matrix(), drawn.classes, {.svm = {.penalty = 7.0}});
  EXPECT_FALSE(fit.held_out);
  EXPECT_EQ(FieldsToText(fit.options), FieldsToText(svm::Options{.penalty = 7.0}));
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(FitSvm(drawn.Matrix(), drawn.classes, {.search = {"C=1,2"}})),
      Error,
      HasSubstr("--search needs --folds"));
}

TEST(FitSvm, SaysWhenAMachineDoesNotConverge) {
  const DiscAndRing drawn(20);
  EXPECT_THROWS_MESSAGE(
      static_cast<void>(
          FitSvm(drawn.Matrix(), drawn.classes, {.svm = {.smo = {.max_iterations = 1}}})),
      Error,
      HasSubstr("no model: "));
}

}  // namespace
}  // namespace handcraft::tools
