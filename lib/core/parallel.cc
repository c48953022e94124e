// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lib/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "lib/core/check.h"

namespace handcraft {

void ParallelFor(std::size_t num_tasks,
                 int num_threads,
                 const std::function<void(std::size_t task)>& task) {
  HC_CHECK(num_threads >= 1, num_threads);
  std::atomic<std::size_t> next_task{0};
  std::mutex failure_mutex;
  std::size_t failed_task = num_tasks;
  std::exception_ptr failure;

  const auto work = [&] {
    for (std::size_t i = next_task++; i < num_tasks; i = next_task++) {
      try {
        task(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (i < failed_task) {
          failed_task = i;
          failure = std::current_exception();
        }
        next_task = num_tasks;
      }
    }
  };

  const std::size_t num_helpers =
      std::min(static_cast<std::size_t>(num_threads), std::max<std::size_t>(num_tasks, 1)) - 1;
  {
    std::vector<std::jthread> helpers;
    helpers.reserve(num_helpers);
    for (std::size_t i = 0; i < num_helpers; ++i) helpers.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

int NumHardwareThreads() noexcept {
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

}  // namespace handcraft
