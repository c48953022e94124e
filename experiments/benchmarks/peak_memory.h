// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

namespace handcraft::experiments {

/// By how much the resident memory of this process peaks, during `call`, above what it is at the
/// start [bytes]. From Linux's /proc/self (clear_refs resets the peak, status tells it); NaN where
/// that is not to be had. Other threads count as well.
[[nodiscard]] double PeakMemoryAbove(const std::function<void()>& call);

}  // namespace handcraft::experiments
