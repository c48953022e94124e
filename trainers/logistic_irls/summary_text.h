// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <span>
#include <string>

#include "trainers/logistic_irls/logistic_irls.h"

namespace handcraft::logistic {

/// Wald's z = weight / standard error and the chance of a larger |z| if the weight were 0.
struct WaldTest {
  double z = 0.0;
  double p_value = 1.0;  ///< erfc(|z| / √2)
};
[[nodiscard]] WaldTest ComputeWaldTest(double weight, double standard_error) noexcept;

/// The table that R's summary(glm) prints: a line a coefficient (estimate, standard error, z,
/// p-value, stars), then the deviances with their degrees of freedom, AIC, how the fit ended.
/// `names`: one a feature, or none ("x0", "x1", …). Coefficients that could not be estimated, and
/// figures that were not computed, read NA. Lines end in '\n'.
[[nodiscard]] std::string SummaryTable(const Result& result,
                                       std::span<const std::string> names = {});

}  // namespace handcraft::logistic
