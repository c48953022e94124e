// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/model_io/provenance.h"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft::model_io {
namespace {

using ::testing::HasSubstr;

TEST(DescribeOrigin, LeavesOutWhatIsEmpty) {
  const auto metadata = DescribeOrigin(
      {.name = "mugs", .hyper_parameters = {{"seed", "7"}}, .metrics = {{"auc", "0.9"}}});
  EXPECT_EQ(metadata.at("hc.name"), "mugs");
  EXPECT_EQ(metadata.at("hc.version"), "1");
  EXPECT_EQ(metadata.at("hc.training.seed"), "7");
  EXPECT_EQ(metadata.at("hc.metrics.auc"), "0.9");
  EXPECT_THAT(metadata.at("hc.tool"), ::testing::StartsWith("handcraft "));
  EXPECT_EQ(metadata.count("hc.task"), 0U);
  EXPECT_EQ(metadata.count("hc.created"), 0U);
}

TEST(DescribeOrigin, WritesATimeOnlyWhenItIsFixed) {
  ASSERT_EQ(::setenv("SOURCE_DATE_EPOCH", "1700000000", 1), 0);
  EXPECT_EQ(DescribeOrigin({}).at("hc.created"), "2023-11-14T22:13:20Z");
  ASSERT_EQ(::setenv("SOURCE_DATE_EPOCH", "today", 1), 0);
  EXPECT_THROWS_MESSAGE(DescribeOrigin({}), Error, HasSubstr("SOURCE_DATE_EPOCH is 'today'"));
  ASSERT_EQ(::unsetenv("SOURCE_DATE_EPOCH"), 0);
}

}  // namespace
}  // namespace handcraft::model_io
