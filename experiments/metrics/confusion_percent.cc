// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/metrics/confusion_percent.h"

#include "lib/core/check.h"

namespace handcraft::experiments {
namespace {

// 100 · weight · part / whole; NaN for an empty whole.
double Percent(double weight, std::size_t part, std::size_t whole) noexcept {
  return 100.0 * weight * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

ConfusionPercent PercentOf(const ConfusionMatrix& matrix) noexcept {
  const std::size_t total = matrix.Total();
  return {
      {{Percent(1.0, matrix.true_negative, total), Percent(1.0, matrix.false_positive, total)},
       {Percent(1.0, matrix.false_negative, total), Percent(1.0, matrix.true_positive, total)}}};
}

ConfusionPercent PercentAtBadShare(const ConfusionMatrix& matrix, double bad_share) {
  HC_CHECK(bad_share >= 0.0 && bad_share <= 1.0, bad_share);
  const double good_share = 1.0 - bad_share;
  return {{{Percent(bad_share, matrix.true_negative, matrix.NumBad()),
            Percent(bad_share, matrix.false_positive, matrix.NumBad())},
           {Percent(good_share, matrix.false_negative, matrix.NumGood()),
            Percent(good_share, matrix.true_positive, matrix.NumGood())}}};
}

double BadShareOf(const ConfusionPercent& percent) noexcept {
  const double bad = percent[0][0] + percent[0][1];
  return bad / (bad + percent[1][0] + percent[1][1]);
}

}  // namespace handcraft::experiments
