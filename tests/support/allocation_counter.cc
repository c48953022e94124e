// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tests/support/allocation_counter.h"

#include <atomic>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HANDCRAFT_COUNTS_ALLOCATIONS 0
#else
#define HANDCRAFT_COUNTS_ALLOCATIONS 1
#endif

namespace {
std::atomic<std::size_t> num_allocations{0};
}  // namespace

#if HANDCRAFT_COUNTS_ALLOCATIONS
// glibc's own entry points stand behind these; operator new ends in malloc as well.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t align, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void* malloc(std::size_t size) {
  num_allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  num_allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  num_allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t align, std::size_t size) {
  num_allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_memalign(align, size);
}
}
#endif

namespace handcraft::testing {

AllocationCounter::AllocationCounter() noexcept : start_(num_allocations.load()) {}

std::size_t AllocationCounter::Count() const noexcept { return num_allocations.load() - start_; }

bool AllocationCounter::Available() noexcept { return HANDCRAFT_COUNTS_ALLOCATIONS != 0; }

}  // namespace handcraft::testing
