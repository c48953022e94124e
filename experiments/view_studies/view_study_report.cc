// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_report.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/report_table.h"
#include "experiments/runner/figure_files.h"
#include "experiments/view_studies/answer_table.h"
#include "experiments/view_studies/error_report.h"
#include "experiments/view_studies/view_study_figures.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

std::string TextOf(const GroupShare* group) {
  if (group == nullptr) return "–";
  return fmt::format("{:.1f} [{:.1f}, {:.1f}] of {}",
                     100.0 * group->share.value,
                     100.0 * group->share.low,
                     100.0 * group->share.high,
                     group->num_views);
}

std::string PublishedText(const std::map<std::string, double>& published, const std::string& name) {
  const auto found = published.find(name);
  return found == published.end() ? "–" : NumberToText(found->second);
}

// A row a group, a column a cell, before them what was published.
ReportTable SharesTable(const ViewStudyRun& run) {
  ReportTable table{.head = {"right of [%]"}};
  if (!run.study.claims.empty()) table.head.push_back(run.study.claim_source);
  for (const ViewCellResult& result : run.results) table.head.push_back(result.id);
  for (const std::string& name : GroupNames(run.results)) {
    std::vector<std::string> row = {name};
    if (!run.study.claims.empty()) row.push_back(PublishedText(run.study.claims, name));
    for (const ViewCellResult& result : run.results) {
      row.push_back(TextOf(FindGroup(result, name)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> Verdicts(const ViewStudyRun& run) {
  std::vector<std::string> verdicts;
  for (const auto& [name, percent] : run.study.claims) {
    for (const ViewCellResult& result : run.results) {
      const GroupShare* const group = FindGroup(result, name);
      if (group == nullptr) continue;
      const double share = 100.0 * group->share.value;
      verdicts.push_back(fmt::format("{}, {}: {:.2f} % {} of {} views; {} has {:.2f} %{}",
                                     result.id,
                                     name,
                                     share,
                                     PercentIntervalText(group->share),
                                     group->num_views,
                                     run.study.claim_source,
                                     percent,
                                     share >= percent ? ": reached" : ": not reached"));
    }
  }
  return verdicts;
}

// Three digits, and no fewer than the whole number has.
std::string TimeText(double time) {
  if (std::isnan(time)) return "–";
  return time >= 100.0 ? fmt::format("{:.0f}", time) : fmt::format("{:.3g}", time);
}

ReportTable TimesTable(const ViewStudyRun& run) {
  ReportTable table{.head = {"cell"}};
  std::vector<std::string> published = {run.study.claim_source};
  for (const TimeFigure& time : run.results.front().times) {
    table.head.push_back(time.name);
    published.push_back(PublishedText(run.study.claimed_ms, time.name));
  }
  for (const ViewCellResult& result : run.results) {
    std::vector<std::string> row = {result.id};
    for (const TimeFigure& time : result.times) row.push_back(TimeText(time.value));
    row.resize(table.head.size());
    table.rows.push_back(std::move(row));
  }
  if (!run.study.claimed_ms.empty()) table.rows.push_back(std::move(published));
  return table;
}

std::string HeaderText(const ViewStudyRun& run) {
  std::string text =
      fmt::format("<header><p class=\"kicker\">Study {} · {} cells · {} views</p>\n<h1>{}</h1>\n",
                  EscapeHtml(run.study.name),
                  run.cells.size(),
                  (run.test ? *run.test : run.train).items.size(),
                  EscapeHtml(run.study.title));
  if (!run.study.question.empty()) {
    text += fmt::format("<p class=\"lead\">{}</p>\n", EscapeHtml(run.study.question));
  }
  text += "<ul>\n";
  for (const std::string& verdict : Verdicts(run)) {
    text += fmt::format("<li>{}</li>\n", EscapeHtml(verdict));
  }
  return text + "</ul>\n</header>\n";
}

std::string AnswersText(const ViewStudyRun& run) {
  std::string text =
      "<h2>Answers</h2>\n<p class=\"note\">Rows are what is true, columns what was "
      "answered; counts. Right answers are green.</p>\n";
  for (const ViewCellResult& result : run.results) {
    text += fmt::format("<figure class=\"card wide\"><h3>{}</h3>\n{}</figure>\n",
                        EscapeHtml(result.id),
                        AnswerTable(result.answers));
  }
  return text;
}

std::string InputsText(const ViewStudyRun& run) {
  std::string text = "<h2>Inputs</h2>\n<dl>\n";
  for (const std::string& line : CanonicalLines(run.study)) {
    const std::size_t equals = line.find(" = ");
    text += fmt::format("<dt>{}</dt><dd>{}</dd>\n",
                        EscapeHtml(line.substr(0, equals)),
                        EscapeHtml(line.substr(equals + 3)));
  }
  return text + fmt::format("<dt>views</dt><dd><code>{}</code></dd>\n</dl>\n",
                            EscapeHtml(datasets::Fingerprint(run.train)));
}

// What became of the plans of a cell: a row an object and group.
ReportTable OutcomesTable(const ViewCellResult& result) {
  ReportTable table{.head = {"object"}};
  const AnswerCounts& answers = result.answers;
  table.head.insert(table.head.end(), answers.columns.begin(), answers.columns.end());
  table.head.emplace_back("right [%]");
  for (std::size_t row = 0; row < answers.rows.size(); ++row) {
    std::vector<std::string> cells = {answers.rows[row]};
    for (const std::size_t count : answers.counts[row]) cells.push_back(NumberToText(count));
    cells.push_back(TextOf(&result.groups[row]));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string OutcomesSection(const ViewStudyRun& run) {
  if (!IsOfPlans(run.study.task)) return "";
  std::string text = "## Outcomes\n\n";
  for (const ViewCellResult& result : run.results) {
    text += fmt::format("{}:\n\n{}", result.id, MarkdownText(OutcomesTable(result)));
  }
  return text;
}

std::string ErrorsSection(const ViewStudyRun& run) {
  const ReportTable errors = ErrorsTable(run);
  return errors.rows.empty() ? "" : "## Errors of the answers kept\n\n" + MarkdownText(errors);
}

std::string SummaryText(const ViewStudyRun& run) {
  std::string text = fmt::format("# {}\n\n", run.study.title);
  if (!run.study.question.empty()) text += run.study.question + "\n\n";
  for (const std::string& verdict : Verdicts(run)) text += "- " + verdict + "\n";
  text += "\n## Right answers\n\nWith 95 % intervals (Wilson).\n\n" +
          MarkdownText(SharesTable(run)) + OutcomesSection(run) + ErrorsSection(run) +
          "## Times\n\n" + MarkdownText(TimesTable(run)) + "## Inputs\n\n";
  for (const std::string& line : CanonicalLines(run.study)) text += "- " + line + "\n";
  return text + "- views: " + datasets::Fingerprint(run.train) + "\n";
}

}  // namespace

GnuplotReport WriteViewStudyReport(const fs::path& out, const ViewStudyRun& run) {
  const ReportTable errors = ErrorsTable(run);
  FigureFiles files = WriteFigures(out / "figures", ViewStudyFigures(run));
  WriteFileAtomically(out / "summary.md", SummaryText(run));
  WriteFileAtomically(
      out / "report.html",
      MakeHtmlPage(run.study.title,
                   HeaderText(run) + "<h2>Right answers</h2>\n" + HtmlText(SharesTable(run)) +
                       (errors.rows.empty() ? "" : "<h2>Errors</h2>\n" + HtmlText(errors)) +
                       FigureCards(files.figures) + AnswersText(run) + "<h2>Times</h2>\n" +
                       HtmlText(TimesTable(run)) + InputsText(run)));
  return std::move(files.gnuplot);
}

}  // namespace handcraft::experiments
