// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/linear_algebra/single_threaded_blas.h"

#include <gtest/gtest.h>

namespace handcraft {
namespace {

TEST(SingleThreadedBlas, HoldsBlasToOneThreadAndRestores) {
  const int before = SingleThreadedBlas::NumThreads();
  EXPECT_GE(before, 1);
  {
    const SingleThreadedBlas outer;
    EXPECT_EQ(SingleThreadedBlas::NumThreads(), 1);
    {
      const SingleThreadedBlas inner;
      EXPECT_EQ(SingleThreadedBlas::NumThreads(), 1);
    }
    EXPECT_EQ(SingleThreadedBlas::NumThreads(), 1);
  }
  EXPECT_EQ(SingleThreadedBlas::NumThreads(), before);
}

}  // namespace
}  // namespace handcraft
