// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/rejection_curve.h"

#include <algorithm>

namespace handcraft::experiments {

std::vector<RejectionPoint> RejectionCurve(std::vector<JudgedAnswer> answers) {
  std::sort(answers.begin(), answers.end(), [](const JudgedAnswer& a, const JudgedAnswer& b) {
    return a.doubt < b.doubt;
  });
  std::vector<RejectionPoint> curve;
  std::size_t num_right = 0;
  std::size_t share = 1;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    num_right += answers[i].is_right ? 1 : 0;
    const bool is_last = i + 1 == answers.size();
    if (!is_last && answers[i + 1].doubt == answers[i].doubt) continue;
    if ((i + 1) * kNumRejectionPoints < share * answers.size()) continue;
    curve.push_back({.limit = answers[i].doubt, .num_kept = i + 1, .num_right = num_right});
    while (share * answers.size() <= (i + 1) * kNumRejectionPoints) ++share;
  }
  return curve;
}

}  // namespace handcraft::experiments
