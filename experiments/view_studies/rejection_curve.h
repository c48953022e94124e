// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

namespace handcraft::experiments {

/// An answer and how much speaks against it, in whatever unit: a distance, minus a margin.
struct JudgedAnswer {
  double doubt = 0.0;
  bool is_right = false;
};

/// What is left when answers whose doubt is above a limit are rejected.
struct RejectionPoint {
  double limit = 0.0;
  std::size_t num_kept = 0;
  std::size_t num_right = 0;  ///< of those

  bool operator==(const RejectionPoint&) const = default;
};

inline constexpr std::size_t kNumRejectionPoints = 20;

/// The answers kept as the limit rises so that each of kNumRejectionPoints equal shares of them
/// comes in; the last point keeps all. Equal doubts come in together, so there may be fewer points;
/// none without answers. Source: El-Yaniv and Wiener 2010, "On the foundations of noise-free
/// selective classification", the risk-coverage curve.
[[nodiscard]] std::vector<RejectionPoint> RejectionCurve(std::vector<JudgedAnswer> answers);

}  // namespace handcraft::experiments
