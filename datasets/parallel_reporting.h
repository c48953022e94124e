// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstddef>
#include <string_view>
#include <thread>

#include "lib/core/parallel.h"
#include "lib/core/progress.h"

namespace handcraft::datasets {

/// ParallelFor that reports how many tasks are done: from the caller's thread alone, whenever it
/// has finished one of its own, and once at the end.
template <class Task>
void ParallelForReporting(std::size_t num_tasks,
                          int num_threads,
                          const Progress& progress,
                          std::string_view stage,
                          const Task& task) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done = 0;
  ParallelFor(num_tasks, num_threads, [&](std::size_t i) {
    task(i);
    ++done;
    if (std::this_thread::get_id() == caller) Report(progress, stage, done, num_tasks);
  });
  Report(progress, stage, num_tasks, num_tasks);
}

}  // namespace handcraft::datasets
