// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/features/grasp_library.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/lib/features/some_grasp_library.h"

namespace handcraft::features {
namespace {

TEST(GraspLibrary, GivesEachClassItsPart) {
  const GraspLibrary library = testing::SomeGraspLibrary();
  ASSERT_EQ(library.NumClasses(), 2U);
  const ShownClass first = library.Class(0);
  const ShownClass second = library.Class(1);
  EXPECT_EQ(first.views.size(), 12U);
  EXPECT_EQ(second.views.size(), 12U);
  EXPECT_EQ(second.views.normals.data(), library.view_normals.data() + 36);
  EXPECT_EQ(second.views.moments.data(), library.view_moments.data() + 12 * kNumMoments);
  EXPECT_EQ(second.views.scales.data(), library.moment_scales.data() + kNumMoments);
  EXPECT_EQ(second.shown_angles_rad.size(), 4U);
  ASSERT_EQ(second.begins.size(), 5U);
  EXPECT_EQ(second.begins[0], 80);
  EXPECT_EQ(second.begins[4], 160);
}

TEST(GraspLibrary, FindsPosesOfTheAskedClassAlone) {
  const GraspLibrary library = testing::SomeGraspLibrary();
  for (std::size_t c = 0; c < 2; ++c) {
    for (int angle = 0; angle < 4; ++angle) {
      const FoundGrasp found =
          FindGraspAt(library.Class(c), 0.5 * std::numbers::pi * angle, {}, {});
      EXPECT_EQ(found.number / 20, static_cast<int>(c) * 4 + angle);
      EXPECT_EQ(found.turn_rad, 0.0);
    }
  }
}

TEST(GraspLibrary, OfNothingHasNoClass) { EXPECT_EQ(GraspLibrary{}.NumClasses(), 0U); }

}  // namespace
}  // namespace handcraft::features
