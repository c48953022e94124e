// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/binary_labels.h"

#include <vector>

#include <gtest/gtest.h>

#include "lib/core/error.h"
#include "tests/support/expect_throws_message.h"

namespace handcraft {
namespace {

using ::testing::HasSubstr;
using Labels = std::vector<std::uint8_t>;

TEST(BinaryLabels, CountsTheOnes) { EXPECT_EQ(CountPositive(Labels{0, 1, 1, 0, 1}), 3U); }

TEST(BinaryLabels, RefusesOneClassAloneAndNone) {
  EXPECT_THROWS_MESSAGE(CountPositive(Labels{0, 0}), Error, HasSubstr("all 2 labels are 0"));
  EXPECT_THROWS_MESSAGE(CountPositive(Labels{1}), Error, HasSubstr("all 1 labels are 1"));
  EXPECT_THROWS_MESSAGE(CountPositive(Labels{}), Error, HasSubstr("nothing to tell apart"));
}

TEST(BinaryLabels, NamesTheRowOfAnotherLabel) {
  EXPECT_THROWS_MESSAGE(
      CountPositive(Labels{0, 1, 7}), Error, HasSubstr("label of row 2 (counted from 0) is 7"));
}

}  // namespace
}  // namespace handcraft
