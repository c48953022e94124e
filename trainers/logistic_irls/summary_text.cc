// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "trainers/logistic_irls/summary_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "lib/core/check.h"

namespace handcraft::logistic {
namespace {

constexpr double kNotAvailable = std::numeric_limits<double>::quiet_NaN();

std::string NumberText(double value, int digits) {
  return std::isnan(value) ? "NA" : fmt::format("{:.{}g}", value, digits);
}

std::string PValueText(double p) {
  if (std::isnan(p)) return "NA";
  return p < 2e-16 ? "<2e-16" : fmt::format("{:.3g}", p);
}

std::string_view Stars(double p) {
  if (p < 0.001) return " ***";
  if (p < 0.01) return " **";
  if (p < 0.05) return " *";
  if (p < 0.1) return " .";
  return "";
}

std::string CoefficientLine(std::string_view name,
                            std::size_t name_width,
                            double weight,
                            double standard_error) {
  const WaldTest wald = ComputeWaldTest(weight, standard_error);
  return fmt::format("{:<{}} {:>13} {:>13} {:>9} {:>9}{}\n",
                     name,
                     name_width,
                     NumberText(weight, 6),
                     NumberText(standard_error, 6),
                     NumberText(wald.z, 4),
                     PValueText(wald.p_value),
                     Stars(wald.p_value));
}

std::string FitLines(const Summary& summary) {
  return fmt::format(
      "    Null deviance: {:.6g}  on {} degrees of freedom\n"
      "Residual deviance: {:.6g}  on {} degrees of freedom\n"
      "AIC: {:.6g}\n\n"
      "{}: {}\n"
      "Newton steps: {} ({} with a subsample's Hessian, {} halvings); "
      "gradient norm {:.2g} a sample; reciprocal condition {:.2g}\n",
      summary.null_deviance,
      summary.num_samples - 1,
      summary.deviance,
      summary.num_samples - std::min(summary.num_samples, summary.rank),
      summary.aic,
      NameOf(summary.termination),
      summary.advice.empty() ? summary.message : summary.message + "; " + summary.advice,
      summary.iterations,
      summary.warm_start_iterations,
      summary.step_halvings,
      summary.gradient_norm,
      summary.reciprocal_condition);
}

}  // namespace

WaldTest ComputeWaldTest(double weight, double standard_error) noexcept {
  const double z = weight / standard_error;
  return {.z = z, .p_value = std::erfc(std::abs(z) / std::numbers::sqrt2)};
}

std::string SummaryTable(const Result& result, std::span<const std::string> names) {
  const std::size_t num_features = result.weights.size();
  HC_CHECK(names.empty() || names.size() == num_features, names.size(), num_features);
  const bool has_errors = !result.standard_errors.empty();
  std::vector<std::string> labels(names.begin(), names.end());
  for (std::size_t j = labels.size(); j < num_features; ++j)
    labels.push_back(fmt::format("x{}", j));
  std::size_t width = std::string_view("(Intercept)").size();
  for (const std::string& label : labels) width = std::max(width, label.size());

  std::string text = fmt::format("Coefficients:\n{:<{}} {:>13} {:>13} {:>9} {:>9}\n",
                                 "",
                                 width,
                                 "Estimate",
                                 "Std. Error",
                                 "z value",
                                 "Pr(>|z|)");
  text += CoefficientLine("(Intercept)",
                          width,
                          result.intercept,
                          has_errors ? result.intercept_standard_error : kNotAvailable);
  const std::vector<std::size_t>& aliased = result.summary.aliased_features;
  for (std::size_t j = 0; j < num_features; ++j) {
    const bool is_aliased = std::binary_search(aliased.begin(), aliased.end(), j);
    text += CoefficientLine(labels[j],
                            width,
                            is_aliased ? kNotAvailable : result.weights[j],
                            has_errors && !is_aliased ? result.standard_errors[j] : kNotAvailable);
  }
  text += "---\nSignif. codes: 0 '***' 0.001 '**' 0.01 '*' 0.05 '.' 0.1 ' ' 1\n\n";
  return text + FitLines(result.summary);
}

}  // namespace handcraft::logistic
