// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/study_page.h"

#include <cmath>
#include <span>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/pixel_cards.h"
#include "experiments/evaluation/report_table.h"
#include "experiments/runner/study_confusion.h"
#include "experiments/runner/summary_markdown.h"

namespace handcraft::experiments {
namespace {

std::string HeaderText(const StudyRun& run, const StudySummary& summary) {
  const Study& study = run.study;
  std::string text =
      fmt::format("<header><p class=\"kicker\">Study {} · {} cells</p>\n<h1>{}</h1>\n",
                  EscapeHtml(study.name),
                  run.cells.size(),
                  EscapeHtml(study.title));
  if (!study.question.empty()) {
    text += fmt::format("<p class=\"lead\">{}</p>\n", EscapeHtml(study.question));
  }
  const std::string verdict = VerdictText(study, summary);
  if (!verdict.empty()) text += fmt::format("<p>{}</p>\n", EscapeHtml(verdict));
  return text + "</header>\n";
}

std::string HeadRow(const std::vector<std::string>& names) {
  std::string row = "<tr>";
  for (std::size_t i = 0; i < names.size(); ++i) {
    row += fmt::format(
        "<th scope=\"col\"{}>{}</th>", i == 0 ? "" : " class=\"number\"", EscapeHtml(names[i]));
  }
  return "<thead>" + row + "</tr></thead>\n";
}

std::string NumberCell(const std::string& value, const std::string& range, double tint) {
  const std::string style =
      std::isnan(tint) ? std::string()
                       : fmt::format(" style=\"background: rgba(20, 140, 130, {:.2f})\"", tint);
  return fmt::format(
      "<td class=\"number\"{}>{}<span class=\"range\">{}</span></td>", style, value, range);
}

std::string ByClassText(const StudySummary& summary) {
  std::vector<std::string> head = {"class"};
  for (const SeriesSummary& series : summary.series) head.push_back(series.label);
  std::string rows;
  for (std::size_t k = 0; k < summary.classes.size(); ++k) {
    rows += fmt::format("<tr{}><th scope=\"row\">{}</th>",
                        k + 1 == summary.classes.size() ? " class=\"total\"" : "",
                        EscapeHtml(summary.classes[k]));
    for (const SeriesSummary& series : summary.series) {
      const Estimate& accuracy = series.by_class[k].figures.best_pixel_accuracy;
      rows += NumberCell(
          PercentText(accuracy.value), PercentIntervalText(accuracy), 0.5 * accuracy.value);
    }
    rows += "</tr>\n";
  }
  return "<h2>Best-pixel accuracy by class</h2>\n<p class=\"note\">Of the up to 15 best pixels of "
         "each image that lie on labelled ground, those on good ground; 95 % intervals over "
         "images, an image with all its repetitions together.</p>\n<div class=\"scroll\"><table>" +
         HeadRow(head) + "<tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string PointsCell(const Estimate& difference) {
  if (std::isnan(difference.value)) return "<td class=\"number\">–</td>";
  const std::string value = fmt::format("{:+.2f}", 100.0 * difference.value);
  if (std::isnan(difference.low)) return NumberCell(value, "", std::nan(""));
  return NumberCell(
      value,
      fmt::format("[{:+.2f}, {:+.2f}]", 100.0 * difference.low, 100.0 * difference.high),
      std::nan(""));
}

std::string DifferencesText(const Study& study, const StudySummary& summary) {
  std::string rows;
  for (const SeriesSummary& series : summary.series) {
    const auto& difference = series.by_class.back().difference;
    if (!difference) continue;
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", EscapeHtml(series.label)) +
            PointsCell(difference->best_pixel_accuracy) +
            PointsCell(difference->best_pixel_accuracy_with_both) +
            fmt::format("<td class=\"number\">{} of {}</td>",
                        difference->num_images_with_both,
                        difference->num_images) +
            PointsCell(difference->accuracy) + PointsCell(difference->brier) + "</tr>\n";
  }
  if (rows.empty()) return {};
  return fmt::format(
             "<h2>Difference to {}</h2>\n<p class=\"note\">On the same images, in points; "
             "95 % intervals of the paired bootstrap over images. An interval without 0 is "
             "a difference that the images can tell.</p>\n<div class=\"scroll\"><table>",
             EscapeHtml(study.baseline)) +
         HeadRow({"method",
                  "best pixels",
                  "where both have some",
                  "images with both",
                  "accuracy at 0.5",
                  "Brier score × 100"}) +
         "<tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string PixelsText(const StudyRun& run, const StudySummary& summary) {
  const EvaluationOptions defaults;  // a study does not change these thresholds
  std::string text =
      "<h2>Labelled pixels</h2>\n<p class=\"note\">As many good as bad in each image. Areas and "
      "average precision with 95 % intervals over images, means over repetitions; confusion "
      "matrices of all repetitions together, curves and reliability of the first.</p>\n" +
      HtmlText(PixelFiguresTable(run, summary));
  for (const SeriesSummary& series : summary.series) {
    const PooledFigures& figures = series.by_class.back().figures;
    text += fmt::format("<h2>{}</h2>\n<div class=\"plots\">\n{}</div>\n",
                        EscapeHtml(series.label),
                        PixelCards({.confusion = series.confusion,
                                    .rates = figures.rates,
                                    .threshold = defaults.threshold,
                                    .strict_confusion = series.strict_confusion,
                                    .strict_rates = figures.strict_rates,
                                    .strict_threshold = defaults.best_min_probability,
                                    .auc = series.auc,
                                    .average_precision = series.average_precision,
                                    .brier = figures.brier},
                                   run.results[series.cells.front()].curves));
  }
  return text;
}

std::string LdaConfusionText(const StudyRun& run, const StudySummary& summary) {
  const ReportTable table = LdaConfusionTable(run, summary);
  if (table.rows.empty()) return {};
  return "<h2>Confusion matrices beside the dissertation</h2>\n<p class=\"note\">Percent of all "
         "pixels; 95 % intervals over images, the share of bad pixels taken as known.</p>\n" +
         HtmlText(table);
}

std::string StageRows(const SeriesSummary& series) {
  constexpr const char* kRow =
      "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td></tr>\n";
  const std::string label = EscapeHtml(series.label);
  std::string rows;
  for (const SearchStageFigures& stage : series.search_space.stages) {
    rows += fmt::format(fmt::runtime(kRow),
                        label,
                        stage.stage,
                        DecimalText(stage.num_pixels, 0),
                        DecimalText(stage.time_ms, 2));
  }
  if (const std::size_t none = series.search_space.num_images_without_region; none > 0) {
    rows += fmt::format(fmt::runtime(kRow), label, "pictures without a region", none, "");
  }
  return rows;
}

std::string SearchSpaceText(const StudySummary& summary) {
  std::string rows;
  for (const SeriesSummary& series : summary.series) rows += StageRows(series);
  if (rows.empty()) return {};
  return "<h2>Search space</h2>\n<p class=\"note\">What each stage of search-space reduction left "
         "of a picture, and how long it took; means over pictures.</p>\n<div class=\"scroll\">"
         "<table><thead><tr><th scope=\"col\">method</th><th scope=\"col\">left after</th>"
         "<th scope=\"col\" class=\"number\">pixels</th><th scope=\"col\" class=\"number\">time "
         "[ms]</th></tr></thead>\n<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string ExampleText(const Example& example) {
  std::string cards = fmt::format(
      "<figure class=\"card\"><img class=\"overlay\" alt=\"Labels of {0}\" src=\"{1}\">"
      "<figcaption><strong>{0}</strong> · {2}<br>labels</figcaption></figure>\n",
      EscapeHtml(example.image),
      DataUri("image/jpeg", example.labels_jpeg),
      EscapeHtml(example.object_class));
  for (const ExampleOverlay& overlay : example.overlays) {
    cards += fmt::format(
        "<figure class=\"card\"><img class=\"overlay\" alt=\"{0} on {1}\" src=\"{2}\">"
        "<figcaption><strong>{0}</strong><br>{3} of {4} good</figcaption></figure>\n",
        EscapeHtml(overlay.label),
        EscapeHtml(example.image),
        DataUri("image/jpeg", overlay.jpeg),
        overlay.best.good,
        overlay.best.good + overlay.best.bad);
  }
  return "<div class=\"gallery\">\n" + cards + "</div>\n";
}

std::string ExamplesText(const std::vector<Example>& examples) {
  if (examples.empty()) return {};
  std::string text =
      "<h2>Examples</h2>\n<p class=\"note\">Probability of a grasp point, warm, and the "
      "best pixels, numbered; first repetition.</p>\n";
  for (const Example& example : examples) text += ExampleText(example);
  return text;
}

std::string FooterText(const StudyRun& run, const StudySummary& summary) {
  std::string text;
  if (!summary.warnings.empty()) {
    text += "<h2>Warnings</h2>\n<ul>\n";
    for (const std::string& warning : summary.warnings) {
      text += fmt::format("<li>{}</li>\n", EscapeHtml(warning));
    }
    text += "</ul>\n";
  }
  text += "<h2>Inputs</h2>\n<dl>\n";
  for (const std::string& line : CanonicalLines(run.study)) {
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos) continue;
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n",
                        EscapeHtml(line.substr(0, equals)),
                        EscapeHtml(line.substr(equals + 3)));
  }
  return text + fmt::format("<dt>pictures</dt><dd><code>{}</code></dd>\n</dl>\n",
                            EscapeHtml(run.data.train_fingerprint));
}

}  // namespace

std::string MakeStudyPage(const StudyRun& run,
                          const StudySummary& summary,
                          const std::vector<PageFigure>& figures,
                          const std::vector<Example>& examples) {
  return MakeHtmlPage(run.study.title,
                      HeaderText(run, summary) + ByClassText(summary) + FigureCards(figures) +
                          DifferencesText(run.study, summary) + PixelsText(run, summary) +
                          LdaConfusionText(run, summary) + SearchSpaceText(summary) +
                          ExamplesText(examples) + FooterText(run, summary));
}

}  // namespace handcraft::experiments
