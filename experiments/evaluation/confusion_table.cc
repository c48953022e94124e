// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/evaluation/confusion_table.h"

#include <cstddef>

#include <fmt/format.h>

#include "experiments/evaluation/grasp_point_templates.h"
#include "experiments/evaluation/html_text.h"

namespace handcraft::experiments {
namespace {

std::string CountCell(std::size_t count, std::size_t row_total, bool is_right) {
  const double share =
      row_total == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(row_total);
  return fmt::format(
      "<td style=\"background: rgba({}, {:.2f})\"><span class=\"count\">{}</span>"
      "<span class=\"share\">{}</span></td>",
      is_right ? "20, 140, 130" : "205, 95, 40",
      0.08 + 0.5 * share,
      count,
      row_total == 0 ? "–" : PercentText(share));
}

}  // namespace

std::string ConfusionTable(const ConfusionMatrix& matrix, double threshold) {
  const std::size_t num_good = matrix.NumGood();
  const std::size_t num_bad = matrix.NumBad();
  return fmt::format(fmt::runtime(kConfusionTemplate),
                     fmt::arg("threshold", fmt::format("{:g}", threshold)),
                     fmt::arg("true_positive", CountCell(matrix.true_positive, num_good, true)),
                     fmt::arg("false_negative", CountCell(matrix.false_negative, num_good, false)),
                     fmt::arg("false_positive", CountCell(matrix.false_positive, num_bad, false)),
                     fmt::arg("true_negative", CountCell(matrix.true_negative, num_bad, true)));
}

}  // namespace handcraft::experiments
