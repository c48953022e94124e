// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/counted.h"

#include <cstddef>

#include <gtest/gtest.h>

namespace handcraft {
namespace {

TEST(Counted, SaysOneThingOfOne) {
  EXPECT_EQ(Counted(1, "page"), "1 page");
  EXPECT_EQ(Counted(0, "page"), "0 pages");
  EXPECT_EQ(Counted(std::size_t{24}, "page"), "24 pages");
  EXPECT_EQ(Counted(-1, "step"), "-1 steps");
}

TEST(Counted, TakesAnotherWordForMany) {
  EXPECT_EQ(Counted(1, "class", "classes"), "1 class");
  EXPECT_EQ(Counted(2, "class", "classes"), "2 classes");
  EXPECT_EQ(Counted(0, "is", "are"), "0 are");
}

}  // namespace
}  // namespace handcraft
