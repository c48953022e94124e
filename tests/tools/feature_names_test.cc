// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/feature_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace handcraft::tools {
namespace {

using ::testing::ElementsAre;

TEST(FeatureNames, AreThoseOfTheSpecificationInOrder) {
  EXPECT_THAT(
      FeatureNames(features::ParseFeatureSpec("filters=edge_0+laplacian,window=1,scales=3")),
      ElementsAre("edge_0@(0,0)", "laplacian@(0,0)", "edge_0@1/3", "laplacian@1/3"));
}

TEST(FirstNames, CutsALongList) {
  const std::vector<std::string> names = {"a", "b", "c", "d", "e", "f", "g"};
  EXPECT_EQ(FirstNames({}, names), "");
  EXPECT_EQ(FirstNames({1, 2}, names), "b, c");
  EXPECT_EQ(FirstNames({0, 1, 2, 3, 4}, names), "a, b, c, d, e");
  EXPECT_EQ(FirstNames({0, 1, 2, 3, 4, 5, 6}, names), "a, b, c, d, e and 2 more");
}

}  // namespace
}  // namespace handcraft::tools
