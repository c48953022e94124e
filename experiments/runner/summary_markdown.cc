// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/summary_markdown.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/runner/study_confusion.h"

namespace handcraft::experiments {
namespace {

// Names may hold what Markdown would take for a column's end.
std::string Cellular(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '|') escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

std::string Row(const std::vector<std::string>& cells) {
  std::string row = "|";
  for (const std::string& cell : cells) row += " " + Cellular(cell) + " |";
  return row + "\n";
}

std::string Head(const std::vector<std::string>& cells) {
  std::string rule = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) rule += i == 0 ? "---|" : "---:|";
  return Row(cells) + rule + "\n";
}

std::string ShareText(const Estimate& estimate) {
  return fmt::format("{} {}", PercentText(estimate.value), PercentIntervalText(estimate));
}

// A difference with its sign, and its interval where there is one.
std::string SignedText(const Estimate& difference, int decimals, double scale = 1.0) {
  if (std::isnan(difference.value)) return "–";
  std::string text = fmt::format("{:+.{}f}", scale * difference.value, decimals);
  if (std::isnan(difference.low)) return text;
  return text + fmt::format(" [{:+.{}f}, {:+.{}f}]",
                            scale * difference.low,
                            decimals,
                            scale * difference.high,
                            decimals);
}

// A difference of shares, in points.
std::string PointsText(const Estimate& difference) { return SignedText(difference, 2, 100.0); }

std::string ByClassText(const StudySummary& summary) {
  std::vector<std::string> head = {"class", "images"};
  for (const SeriesSummary& series : summary.series) head.push_back(series.label);
  std::string text = Head(head);
  for (std::size_t k = 0; k < summary.classes.size(); ++k) {
    std::vector<std::string> row = {
        summary.classes[k], std::to_string(summary.series.front().by_class[k].figures.num_images)};
    for (const SeriesSummary& series : summary.series) {
      row.push_back(ShareText(series.by_class[k].figures.best_pixel_accuracy));
    }
    text += Row(row);
  }
  return text;
}

std::string DifferencesText(const StudySummary& summary) {
  std::string text = Head({"method",
                           "best pixels [points]",
                           "where both have some [points]",
                           "images with both",
                           "accuracy [points]",
                           "log-loss",
                           "Brier score"});
  for (const SeriesSummary& series : summary.series) {
    const std::optional<Difference>& difference = series.by_class.back().difference;
    if (!difference) continue;
    text += Row({series.label,
                 PointsText(difference->best_pixel_accuracy),
                 PointsText(difference->best_pixel_accuracy_with_both),
                 fmt::format("{} of {}", difference->num_images_with_both, difference->num_images),
                 PointsText(difference->accuracy),
                 SignedText(difference->log_loss, 4),
                 SignedText(difference->brier, 4)});
  }
  return text;
}

std::string SearchSpaceText(const StudySummary& summary) {
  std::string rows;
  for (const SeriesSummary& series : summary.series) {
    for (const SearchStageFigures& stage : series.search_space.stages) {
      rows += Row({series.label,
                   stage.stage,
                   DecimalText(stage.num_pixels, 0),
                   DecimalText(stage.time_ms, 2)});
    }
    if (const std::size_t none = series.search_space.num_images_without_region; none > 0) {
      rows += Row({series.label, "pictures without a region", std::to_string(none), ""});
    }
  }
  if (rows.empty()) return {};
  return "\n## Search space\n\nMeans over pictures.\n\n" +
         Head({"method", "left after", "pixels", "time [ms]"}) + rows;
}

std::string RowsText(const ReportTable& table) {
  std::string text = Head(table.head);
  for (const std::vector<std::string>& row : table.rows) text += Row(row);
  return text;
}

std::string PixelsText(const StudyRun& run, const StudySummary& summary) {
  return "\n## Labelled pixels\n\n" + RowsText(PixelFiguresTable(run, summary)) +
         "\nConfusion matrices: pixels, and their share of the good or bad ones.\n\n" +
         RowsText(ConfusionCountsTable(summary));
}

std::string LdaConfusionText(const StudyRun& run, const StudySummary& summary) {
  const ReportTable table = LdaConfusionTable(run, summary);
  if (table.rows.empty()) return {};
  return "\n## Confusion matrices beside the dissertation\n\nPercent of all pixels; "
         "95 % intervals over images, the share of bad pixels taken as known.\n\n" +
         RowsText(table);
}

std::string InputsText(const StudyRun& run) {
  std::string text = fmt::format(
      "- pictures to train on: {} ({})\n", run.data.train.items.size(), run.data.train_fingerprint);
  if (run.data.test) {
    text += fmt::format("- pictures to test with: {} ({})\n",
                        run.data.test->items.size(),
                        run.data.test_fingerprint);
  }
  for (const std::string& line : CanonicalLines(run.study)) text += "- " + line + "\n";
  return text;
}

// What the interval leaves open is said with the verdict.
std::string DoubtText(const ClaimVerdict& verdict, double limit_points) {
  if (verdict.holds && verdict.loss_points.high > limit_points) {
    return ", but the interval reaches beyond that limit";
  }
  if (!verdict.holds && verdict.loss_points.low <= limit_points) {
    return ", but the interval holds smaller losses too";
  }
  return {};
}

}  // namespace

std::string VerdictText(const Study& study, const StudySummary& summary) {
  if (!study.claim || !summary.verdict) return {};
  const ClaimVerdict& verdict = *summary.verdict;
  const std::string begin = fmt::format(
      "{} says: no method is more than {} points below {}. Here the worst loss is {:.2f} points",
      study.claim->source,
      study.claim->worst_loss_points,
      study.baseline,
      verdict.loss_points.value);
  if (std::isnan(verdict.loss_points.low)) {
    return fmt::format(
        "{} ({}): too few pictures to tell whether this holds.", begin, verdict.worst);
  }
  return fmt::format(
      "{} [{:.2f}, {:.2f}] ({}): {}{}.",
      begin,
      verdict.loss_points.low,
      verdict.loss_points.high,
      verdict.worst,
      verdict.holds ? "this holds on these data" : "this does not hold on these data",
      DoubtText(verdict, study.claim->worst_loss_points));
}

std::string SummaryMarkdown(const StudyRun& run, const StudySummary& summary) {
  const Study& study = run.study;
  std::string text = fmt::format("# {}\n\n", study.title);
  if (!study.question.empty()) text += study.question + "\n\n";
  text +=
      "## Best-pixel accuracy\n\nWith 95 % intervals over images, an image with all its "
      "repetitions together.\n\n" +
      ByClassText(summary);
  const std::string differences = DifferencesText(summary);
  text += fmt::format(
      "\n## Difference to {}\n\nOn the same images; 95 % intervals of the paired "
      "bootstrap.\n\n{}",
      study.baseline,
      differences);
  const std::string verdict = VerdictText(study, summary);
  if (!verdict.empty()) text += "\n" + verdict + "\n";
  text += PixelsText(run, summary);
  text += LdaConfusionText(run, summary) + SearchSpaceText(summary);
  if (!summary.warnings.empty()) {
    text += fmt::format("\n## Warnings\n\n- {}\n", fmt::join(summary.warnings, "\n- "));
  }
  return text + "\n## Inputs\n\n" + InputsText(run);
}

}  // namespace handcraft::experiments
