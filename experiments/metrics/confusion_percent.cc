// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/confusion_percent.h"

#include "lib/core/check.h"

namespace handcraft::experiments {
namespace {

Estimate Percent(double weight, const Estimate& share) noexcept {
  const double factor = 100.0 * weight;
  return {factor * share.value, factor * share.low, factor * share.high};
}

}  // namespace

ConfusionPercentEstimate PercentAtBadShare(const ConfusionRates& rates, double bad_share) {
  HC_CHECK(bad_share >= 0.0 && bad_share <= 1.0, bad_share);
  const double good_share = 1.0 - bad_share;
  return {{{Percent(bad_share, rates.true_negative_rate),
            Percent(bad_share, Complement(rates.true_negative_rate))},
           {Percent(good_share, Complement(rates.true_positive_rate)),
            Percent(good_share, rates.true_positive_rate)}}};
}

ConfusionPercent ValuesOf(const ConfusionPercentEstimate& percent) noexcept {
  return {{{percent[0][0].value, percent[0][1].value}, {percent[1][0].value, percent[1][1].value}}};
}

double BadShareOf(const ConfusionPercent& percent) noexcept {
  const double bad = percent[0][0] + percent[0][1];
  return bad / (bad + percent[1][0] + percent[1][1]);
}

double BadShareOf(const ConfusionMatrix& matrix) noexcept {
  if (matrix.Total() == 0) return 0.0;
  return static_cast<double>(matrix.NumBad()) / static_cast<double>(matrix.Total());
}

}  // namespace handcraft::experiments
