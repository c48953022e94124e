// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/parallel.h"

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "tests/support/expect_throws_message.h"

namespace handcraft {
namespace {

TEST(ParallelFor, RunsEachTaskOnce) {
  for (const int num_threads : {1, 2, 7}) {
    std::vector<std::atomic<int>> runs(1000);
    ParallelFor(runs.size(), num_threads, [&](std::size_t i) { ++runs[i]; });
    for (const auto& count : runs) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, TakesNoTasks) {
  ParallelFor(0, 4, [](std::size_t) { FAIL() << "there is no task"; });
}

TEST(ParallelFor, Rethrows) {
  for (const int num_threads : {1, 2, 7}) {
    const auto run = [&] {
      ParallelFor(1000, num_threads, [](std::size_t i) {
        if (i == 3) throw std::runtime_error("task 3");
      });
    };
    EXPECT_THROWS_MESSAGE(run(), std::runtime_error, ::testing::StrEq("task 3"));
  }
}

// With one thread the count is certain; with more, the others may take any number meanwhile.
TEST(ParallelFor, StartsNothingAfterAFailure) {
  int runs = 0;
  const auto run = [&] {
    ParallelFor(1000, 1, [&](std::size_t i) {
      ++runs;
      if (i == 3) throw std::runtime_error("task 3");
    });
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_EQ(runs, 4);
}

TEST(ParallelFor, RefusesNoThreads) {
  EXPECT_THROW(ParallelFor(1, 0, [](std::size_t) {}), std::logic_error);
}

}  // namespace
}  // namespace handcraft
