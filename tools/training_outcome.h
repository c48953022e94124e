// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "tools/console.h"
#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::tools {

/// Whether the weights are the maximum-likelihood ones: converged, or converged with redundant
/// features left out.
[[nodiscard]] bool IsUsable(const logistic::Summary& summary) noexcept;

/// Says what a trainer's result is worth: warns on `console.err` when features were redundant
/// (named by `feature_names`), and throws Error(kNoResult) with the remedy when it is not usable.
void RequireUsable(const logistic::Summary& summary,
                   const std::vector<std::string>& feature_names,
                   const Console& console);

}  // namespace handcraft::tools
