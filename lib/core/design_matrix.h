// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

namespace handcraft {

/// Row-major num_samples × num_features numbers in the caller's memory.
template <class T>
struct DesignMatrix {
  const T* data = nullptr;
  std::size_t num_samples = 0;
  std::size_t num_features = 0;
  std::size_t stride = 0;  ///< numbers from one row to the next, ≥ num_features

  [[nodiscard]] const T* Row(std::size_t i) const noexcept { return data + i * stride; }
};

}  // namespace handcraft
