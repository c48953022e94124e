// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/confusion_table.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "experiments/evaluation/grasp_point_templates.h"
#include "experiments/evaluation/html_text.h"

namespace handcraft::experiments {
namespace {

enum class Call { kRight, kWrong };

std::string CountCell(std::size_t count, const Estimate& share, Call call) {
  return fmt::format(
      "<td style=\"background: rgba({}, {:.2f})\"><span class=\"count\">{}</span>"
      "<span class=\"share\">{}</span><span class=\"range\">{}</span></td>",
      call == Call::kRight ? "20, 140, 130" : "205, 95, 40",
      0.08 + 0.5 * (std::isnan(share.value) ? 0.0 : share.value),
      count,
      PercentText(share.value),
      PercentIntervalText(share));
}

}  // namespace

std::string ConfusionTable(const ConfusionMatrix& matrix,
                           const ConfusionRates& rates,
                           double threshold) {
  const Estimate& good_found = rates.true_positive_rate;
  const Estimate& bad_refused = rates.true_negative_rate;
  const Estimate good_missed = Complement(good_found);
  const Estimate bad_taken = Complement(bad_refused);
  return fmt::format(
      fmt::runtime(kConfusionTemplate),
      fmt::arg("threshold", fmt::format("{:g}", threshold)),
      fmt::arg("true_positive", CountCell(matrix.true_positive, good_found, Call::kRight)),
      fmt::arg("false_negative", CountCell(matrix.false_negative, good_missed, Call::kWrong)),
      fmt::arg("false_positive", CountCell(matrix.false_positive, bad_taken, Call::kWrong)),
      fmt::arg("true_negative", CountCell(matrix.true_negative, bad_refused, Call::kRight)));
}

}  // namespace handcraft::experiments
