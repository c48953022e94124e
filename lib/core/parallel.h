// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>

namespace handcraft {

/// Runs task(0), …, task(num_tasks − 1), each once, on up to num_threads threads (the caller's is
/// one of them), and returns when all have ended.
///
/// Tasks are taken in ascending order. Results stay independent of the number of threads as long as
/// a task writes only its own output and sums over tasks are formed afterwards in task order.
/// If tasks throw, no new ones start and the exception of the lowest failed task is rethrown.
void ParallelFor(std::size_t num_tasks,
                 int num_threads,
                 const std::function<void(std::size_t task)>& task);

/// Hardware threads of this machine, at least 1: the default of every --threads option.
[[nodiscard]] int NumHardwareThreads() noexcept;

}  // namespace handcraft
