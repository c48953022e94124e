// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <gtest/gtest.h>

namespace handcraft::testing {

/// Whether two sequences agree: |a − b| ≤ tolerance · max(1, |b|) for each entry; the message names
/// the sizes and the worst entry.
template <class A, class B>
::testing::AssertionResult AreClose(const A& actual, const B& expected, double tolerance) {
  if (actual.size() != expected.size()) {
    return ::testing::AssertionFailure()
           << "sizes differ: " << actual.size() << " and " << expected.size();
  }
  double worst = -1.0;
  std::size_t worst_index = 0;
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double a = static_cast<double>(actual[i]);
    const double b = static_cast<double>(expected[i]);
    const double error = std::abs(a - b) / std::max(1.0, std::abs(b));
    if (!(error <= worst)) {
      worst = error;
      worst_index = i;
    }
  }
  if (actual.size() == 0 || worst <= tolerance) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "entry " << worst_index << ": " << actual[worst_index] << " and "
         << expected[worst_index] << " differ by " << worst << " (tolerance " << tolerance << ")";
}

}  // namespace handcraft::testing
