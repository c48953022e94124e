// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_confusion.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/metrics/confusion_percent.h"

namespace handcraft::experiments {
namespace {

std::string CountText(std::size_t count, const Estimate& share) {
  if (std::string range = PercentIntervalText(share); !range.empty()) {
    return fmt::format("{}, {} {}", count, PercentText(share.value), range);
  }
  return fmt::format("{}, {}", count, PercentText(share.value));
}

std::vector<std::string> CountsRow(const std::string& label,
                                   double threshold,
                                   const ConfusionMatrix& matrix,
                                   const ConfusionRates& rates) {
  return {label,
          fmt::format("{:g}", threshold),
          CountText(matrix.true_negative, rates.true_negative_rate),
          CountText(matrix.false_positive, Complement(rates.true_negative_rate)),
          CountText(matrix.false_negative, Complement(rates.true_positive_rate)),
          CountText(matrix.true_positive, rates.true_positive_rate)};
}

// "54.20 [53.1, 55.3]": two digits of the value, as the dissertation has.
std::vector<std::string> PercentRow(std::string label, const ConfusionPercentEstimate& percent) {
  std::vector<std::string> row = {std::move(label)};
  for (const auto& side : percent) {
    for (const Estimate& share : side) row.push_back(DecimalEstimateText(share, 2));
  }
  return row;
}

std::vector<std::string> PercentRow(std::string label, const ConfusionPercent& percent) {
  std::vector<std::string> row = {std::move(label)};
  for (const auto& side : percent) {
    for (const double share : side) row.push_back(DecimalText(share, 2));
  }
  return row;
}

constexpr const char* kBadCalledBad = "bad, called bad";
constexpr const char* kBadCalledGood = "bad, called good";
constexpr const char* kGoodCalledBad = "good, called bad";
constexpr const char* kGoodCalledGood = "good, called good";

}  // namespace

ReportTable PixelFiguresTable(const StudyRun& run, const StudySummary& summary) {
  ReportTable table{.head = {"method",
                             "features",
                             "samples",
                             "AUC",
                             "average precision",
                             "accuracy at 0.5",
                             "log-loss",
                             "Brier score"}};
  for (const SeriesSummary& series : summary.series) {
    const CellResult& first = run.results[series.cells.front()];
    const PooledFigures& figures = series.by_class.back().figures;
    table.rows.push_back(
        {series.label,
         std::to_string(first.num_features),
         std::to_string(first.num_samples),
         DecimalEstimateText(series.auc, 3),
         DecimalEstimateText(series.average_precision, 3),
         PercentText(figures.accuracy.value) + " " + PercentIntervalText(figures.accuracy),
         DecimalEstimateText(figures.log_loss, 4),
         DecimalEstimateText(figures.brier, 4)});
  }
  return table;
}

ReportTable ConfusionCountsTable(const StudySummary& summary) {
  const EvaluationOptions defaults;  // a study does not change these thresholds
  ReportTable table{
      .head = {
          "method", "good above", kBadCalledBad, kBadCalledGood, kGoodCalledBad, kGoodCalledGood}};
  for (const SeriesSummary& series : summary.series) {
    const PooledFigures& figures = series.by_class.back().figures;
    table.rows.push_back(
        CountsRow(series.label, defaults.threshold, series.confusion, figures.rates));
    table.rows.push_back(CountsRow(series.label,
                                   defaults.best_min_probability,
                                   series.strict_confusion,
                                   figures.strict_rates));
  }
  return table;
}

ReportTable LdaConfusionTable(const StudyRun& run, const StudySummary& summary) {
  ReportTable table{
      .head = {"method", kBadCalledBad, kBadCalledGood, kGoodCalledBad, kGoodCalledGood}};
  const bool has_lda = std::any_of(run.cells.begin(), run.cells.end(), [](const Cell& cell) {
    return cell.settings.classifier == Classifier::kLda;
  });
  if (!has_lda) return table;
  table.rows.push_back(PercentRow("dissertation, discriminant analysis", kDissertationLda));
  const double bad_share = BadShareOf(kDissertationLda);
  for (const SeriesSummary& series : summary.series) {
    const ConfusionRates& rates = series.by_class.back().figures.rates;
    table.rows.push_back(
        PercentRow(series.label + ", at its class ratio", PercentAtBadShare(rates, bad_share)));
    table.rows.push_back(PercentRow(series.label + ", as measured",
                                    PercentAtBadShare(rates, BadShareOf(series.confusion))));
  }
  return table;
}

}  // namespace handcraft::experiments
