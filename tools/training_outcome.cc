// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tools/training_outcome.h"

#include <string_view>

#include <fmt/format.h>

#include "lib/core/error.h"
#include "tools/feature_names.h"

namespace handcraft::tools {
namespace {

std::string_view RemedyFor(logistic::Termination termination) noexcept {
  switch (termination) {
    case logistic::Termination::kSeparated:
      return "give --ridge 1, more samples or fewer features";
    case logistic::Termination::kIterationLimit:
      return "raise --max-iterations, or give --ridge 1";
    default:
      return "give --ridge 1 or --hessian double";
  }
}

}  // namespace

bool IsUsable(const logistic::Summary& summary) noexcept {
  return summary.termination == logistic::Termination::kConverged ||
         summary.termination == logistic::Termination::kRankDeficient;
}

void RequireUsable(const logistic::Summary& summary,
                   const std::vector<std::string>& feature_names,
                   const Console& console) {
  if (!IsUsable(summary)) {
    // The trainer's own advice names fields of its options; here people give arguments.
    throw Error({.kind = Error::Kind::kNoResult,
                 .reason = "no model: " + summary.message,
                 .remedy = std::string(RemedyFor(summary.termination))});
  }
  if (!summary.aliased_features.empty()) {
    console.Warn(fmt::format("rank deficient: weights of redundant features are left at 0: {}",
                             FirstNames(summary.aliased_features, feature_names)));
  }
}

}  // namespace handcraft::tools
