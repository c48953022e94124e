// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/svm/rejection.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lib/core/error.h"

namespace handcraft::svm {
namespace {

struct Margin {
  double value;
  bool is_known;
};

void AddMargins(std::span<const double> values,
                bool is_known,
                const std::string& what,
                std::vector<Margin>& margins) {
  if (values.empty()) {
    throw Error({.kind = Error::Kind::kBadInput,
                 .reason = "no margins of " + what +
                           " samples: there is nothing to set the "
                           "threshold of rejection by"});
  }
  for (const double value : values) {
    if (!std::isfinite(value)) {
      throw Error({.kind = Error::Kind::kBadInput,
                   .reason = "a margin of a " + what + " sample is not a finite number",
                   .remedy = "look at the sample's features"});
    }
    margins.push_back({.value = value, .is_known = is_known});
  }
}

}  // namespace

Rejection CalibrateRejection(std::span<const double> known_margins,
                             std::span<const double> novel_margins) {
  std::vector<Margin> margins;
  margins.reserve(known_margins.size() + novel_margins.size());
  AddMargins(known_margins, true, "known", margins);
  AddMargins(novel_margins, false, "novel", margins);
  std::sort(margins.begin(), margins.end(), [](const Margin& a, const Margin& b) {
    return a.value < b.value;
  });
  const auto num_known = static_cast<double>(known_margins.size());
  const auto num_novel = static_cast<double>(novel_margins.size());
  // Below the smallest margin nothing is rejected; above the largest, everything.
  Rejection best{.threshold = margins.front().value,
                 .false_rejection = 0.0,
                 .false_acceptance = 1.0,
                 .balanced_accuracy = 0.5};
  double rejected_known = 0.0;
  double rejected_novel = 0.0;
  for (std::size_t i = 0; i + 1 < margins.size(); ++i) {
    (margins[i].is_known ? rejected_known : rejected_novel) += 1.0;
    if (margins[i].value == margins[i + 1].value) continue;
    const double false_rejection = rejected_known / num_known;
    const double false_acceptance = 1.0 - rejected_novel / num_novel;
    const double accuracy = 1.0 - 0.5 * (false_rejection + false_acceptance);
    if (accuracy <= best.balanced_accuracy) continue;
    best = {.threshold = margins[i].value + 0.5 * (margins[i + 1].value - margins[i].value),
            .false_rejection = false_rejection,
            .false_acceptance = false_acceptance,
            .balanced_accuracy = accuracy};
  }
  return best;
}

}  // namespace handcraft::svm
