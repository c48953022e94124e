// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/rotation_evaluation.h"

#include <cmath>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::experiments {
namespace {

using ::testing::HasSubstr;

struct Turntable {
  datasets::ViewSet set = {};
  std::vector<features::ViewDescription> descriptions = {};

  void Add(const std::string& name,
           const std::string& symmetry,
           double angle_deg,
           double plane_deg,
           double moment) {
    set.items.push_back({.image = name + std::to_string(angle_deg),
                         .object_mask = "m",
                         .object_class = name,
                         .instance = name,
                         .angle_deg = angle_deg,
                         .split = "train",
                         .symmetry = symmetry});
    features::ViewDescription view;
    const double plane_rad = plane_deg * std::numbers::pi / 180.0;
    view.normal = {std::cos(plane_rad), std::sin(plane_rad), 0.0};
    view.moments.fill(1.0);
    view.moments[1] = moment;
    descriptions.push_back(view);
  }
};

// Planes turn with the object: the neighbours are found, or the opposite view, as planes alone
// cannot tell them apart.
TEST(EvaluateRotation, CountsNeighboursAndOppositeViews) {
  Turntable table;
  for (int i = 0; i < 36; ++i) {
    table.Add("drill", "none", 10.0 * i, 10.0 * i, 0.01 * i);
    table.Add("can", "half_turn", 10.0 * i, 10.0 * i, 0.0);
    table.Add("bottle", "round", 10.0 * i, 0.0, 0.0);
  }
  const RotationEvaluation evaluation = EvaluateRotation(table.set, table.descriptions, {});
  ASSERT_EQ(evaluation.classes.size(), 2U);
  EXPECT_EQ(evaluation.classes[0].name, "drill");
  EXPECT_EQ(evaluation.classes[0].num_views, 36U);
  EXPECT_EQ(evaluation.classes[0].num_found, 36U);
  EXPECT_EQ(evaluation.classes[0].histogram[1] + evaluation.classes[0].histogram[35], 36U);
  EXPECT_EQ(evaluation.classes[1].num_found, 36U);
  EXPECT_EQ(evaluation.classes[1].histogram[18], 36U);  // the same plane exactly
  ASSERT_EQ(evaluation.symmetries.size(), 2U);
  EXPECT_EQ(evaluation.symmetries[1].name, "half_turn");
}

TEST(EvaluateRotation, CountsAnOppositeViewAgainstAnObjectWithoutSymmetry) {
  Turntable table;
  for (int i = 0; i < 36; ++i) table.Add("drill", "", 10.0 * i, 10.0 * i, 0.0);
  const RotationEvaluation evaluation = EvaluateRotation(table.set, table.descriptions, {});
  EXPECT_EQ(evaluation.symmetries[0].symmetry, "none");
  EXPECT_EQ(evaluation.symmetries[0].num_found, 0U);
  EXPECT_EQ(evaluation.symmetries[0].Found().value, 0.0);
}

TEST(EvaluateRotation, CountsEachViewOnce) {
  Turntable table;
  for (int i = 0; i < 12; ++i) table.Add("mug", "none", 30.0 * i, 77.0 * i, 0.1 * (i % 5));
  const RotationEvaluation evaluation = EvaluateRotation(table.set, table.descriptions, {});
  const auto& histogram = evaluation.classes[0].histogram;
  EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), std::size_t{0}), 12U);
  EXPECT_EQ(histogram[0], 0U);  // no view finds itself
}

TEST(EvaluateRotation, RefusesViewsWithoutAnAngleOrAlone) {
  Turntable table;
  table.Add("mug", "none", 0.0, 0.0, 0.0);
  const auto evaluate = [&table] {
    static_cast<void>(EvaluateRotation(table.set, table.descriptions, {}));
  };
  EXPECT_THROWS_MESSAGE(evaluate(), Error, HasSubstr("class mug has no other view"));
  table.set.items[0].angle_deg.reset();
  EXPECT_THROWS_MESSAGE(evaluate(), Error, HasSubstr("the view has no angle_deg"));
}

}  // namespace
}  // namespace handcraft::experiments
