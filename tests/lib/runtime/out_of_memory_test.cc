// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

// Loading with an operator new that fails at the n-th call, for every n: an error value each time,
// nothing thrown, nothing leaked (the address sanitizer watches).

#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "lib/runtime/handcraft_runtime.h"
#include "tests/lib/runtime/some_models.h"

namespace {

// Calls left until one fails; negative: never.
long calls_left = -1;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void* Allocate(std::size_t size, std::size_t alignment) {
  if (calls_left == 0) throw std::bad_alloc();
  if (calls_left > 0) --calls_left;
  void* memory = std::aligned_alloc(alignment, (size / alignment + 1) * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Not inlined: the compiler would take the pair of new and free for a mistake.
#define HANDCRAFT_APART __attribute__((noinline))
HANDCRAFT_APART void* operator new(std::size_t size) {
  return Allocate(size, alignof(std::max_align_t));
}
HANDCRAFT_APART void* operator new(std::size_t size, std::align_val_t alignment) {
  return Allocate(size, static_cast<std::size_t>(alignment));
}
HANDCRAFT_APART void operator delete(void* memory) noexcept { std::free(memory); }
HANDCRAFT_APART void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
HANDCRAFT_APART void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
HANDCRAFT_APART void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace handcraft {
namespace {

void ExpectMemoryErrorsUntilItLoads(const model_io::ModelFile& file) {
  const std::vector<std::uint8_t> bytes = model_io::Serialise(file);
  hc_model* model = nullptr;
  long num_failures = 0;
  while (true) {
    hc_error error{};
    calls_left = num_failures;
    const hc_status status = hc_model_load_memory(bytes.data(), bytes.size(), &model, &error);
    calls_left = -1;
    if (status == HC_OK) break;
    ASSERT_EQ(status, HC_ERROR_MEMORY) << error.message;
    ASSERT_EQ(model, nullptr);
    ++num_failures;
  }
  EXPECT_GT(num_failures, 20);
  hc_model_free(model);
}

TEST(OutOfMemory, IsAnErrorValueWhileLoading) {
  ExpectMemoryErrorsUntilItLoads(testing::SomeLogisticModel());
  ExpectMemoryErrorsUntilItLoads(testing::SomeSvmModel());
  ExpectMemoryErrorsUntilItLoads(testing::SomeGraspLibraryModel());
  ExpectMemoryErrorsUntilItLoads(testing::SomeGraspPointModel("edges54"));
  ExpectMemoryErrorsUntilItLoads(testing::SomeGraspPointModel("saxena459"));
}

TEST(OutOfMemory, IsAnErrorValueForTheWorkspace) {
  const std::vector<std::uint8_t> bytes =
      model_io::Serialise(testing::SomeGraspPointModel("edges54"));
  hc_model* model = nullptr;
  ASSERT_EQ(hc_model_load_memory(bytes.data(), bytes.size(), &model, nullptr), HC_OK);
  for (const long calls : {0L, 1L}) {
    hc_workspace* workspace = nullptr;
    calls_left = calls;
    const hc_status status = hc_workspace_create(model, 64, 48, &workspace);
    calls_left = -1;
    EXPECT_EQ(status, HC_ERROR_MEMORY);
    EXPECT_EQ(workspace, nullptr);
  }
  hc_model_free(model);
}

}  // namespace
}  // namespace handcraft
