// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

namespace handcraft::testing {

/// Counts calls of operator new and malloc by this process since construction: a prediction must
/// leave Count() at zero. Linking it replaces the global operators; not under sanitizers that bring
/// their own malloc (Available() tells).
class AllocationCounter {
 public:
  AllocationCounter() noexcept;
  [[nodiscard]] std::size_t Count() const noexcept;
  [[nodiscard]] static bool Available() noexcept;

 private:
  std::size_t start_;
};

}  // namespace handcraft::testing
