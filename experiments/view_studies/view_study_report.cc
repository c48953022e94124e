// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/view_studies/view_study_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/report_table.h"
#include "experiments/runner/figure_files.h"
#include "experiments/view_studies/answer_table.h"
#include "experiments/view_studies/error_report.h"
#include "lib/core/fields.h"
#include "lib/core/file.h"

namespace handcraft::experiments {
namespace {

namespace fs = std::filesystem;

std::string ShareText(const Estimate& share) {
  return PercentText(share.value) + " " + PercentIntervalText(share);
}

// The groups of all cells, rows of the answers first, each once.
std::vector<std::string> GroupNames(const ViewStudyRun& run) {
  std::vector<std::string> names;
  std::vector<std::string> sums;
  for (const ViewCellResult& result : run.results) {
    for (std::size_t g = 0; g < result.groups.size(); ++g) {
      std::vector<std::string>& list = g < result.answers.rows.size() ? names : sums;
      const std::string& name = result.groups[g].name;
      if (std::find(list.begin(), list.end(), name) == list.end()) list.push_back(name);
    }
  }
  names.insert(names.end(), sums.begin(), sums.end());
  return names;
}

// Null when the cell has no such group.
const GroupShare* FindGroup(const ViewCellResult& result, const std::string& name) {
  const auto found = std::find_if(result.groups.begin(),
                                  result.groups.end(),
                                  [&](const GroupShare& group) { return group.name == name; });
  return found == result.groups.end() ? nullptr : &*found;
}

// A row a group, a column a cell.
ReportTable SharesTable(const ViewStudyRun& run) {
  ReportTable table{.head = {"right of"}};
  for (const ViewCellResult& result : run.results) table.head.push_back(result.id);
  for (const std::string& name : GroupNames(run)) {
    std::vector<std::string> row = {name};
    for (const ViewCellResult& result : run.results) {
      const GroupShare* const group = FindGroup(result, name);
      row.push_back(group == nullptr
                        ? "–"
                        : fmt::format("{} of {}", ShareText(group->share), group->num_views));
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

ReportTable TimesTable(const ViewStudyRun& run) {
  ReportTable table{.head = {"cell"}};
  std::vector<std::string> published = {run.study.claim_source};
  for (const TimeFigure& time : run.results.front().times) {
    table.head.push_back(time.name);
    const auto found = run.study.claimed_ms.find(time.name);
    published.push_back(found == run.study.claimed_ms.end() ? "–" : NumberToText(found->second));
  }
  for (const ViewCellResult& result : run.results) {
    std::vector<std::string> row = {result.id};
    for (const TimeFigure& time : result.times) row.push_back(DecimalText(time.value, 4));
    row.resize(table.head.size());
    table.rows.push_back(std::move(row));
  }
  if (!run.study.claimed_ms.empty()) table.rows.push_back(std::move(published));
  return table;
}

BarFigure SharesFigure(const ViewStudyRun& run) {
  BarFigure figure{.title = run.study.title, .y_label = "right [%]", .groups = {}, .series = {}};
  figure.groups = GroupNames(run);
  for (const ViewCellResult& result : run.results) {
    BarFigure::Series series{.name = result.id, .bars = {}};
    for (const std::string& name : figure.groups) {
      Estimate bar{std::nan(""), std::nan(""), std::nan("")};
      if (const GroupShare* const group = FindGroup(result, name)) {
        bar = {100.0 * group->share.value, 100.0 * group->share.low, 100.0 * group->share.high};
      }
      series.bars.push_back(bar);
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
}

// The times that a publication has too, but for their sum: a group each.
BarFigure TimesFigure(const ViewStudyRun& run) {
  BarFigure figure{.title = run.study.title, .y_label = "time [ms]", .groups = {}, .series = {}};
  for (const ViewCellResult& result : run.results) {
    BarFigure::Series series{.name = result.id, .bars = {}};
    figure.groups.clear();
    for (const TimeFigure& time : result.times) {
      if (!run.study.claimed_ms.contains(time.name) || time.name == "all_ms") continue;
      figure.groups.push_back(time.name);
      series.bars.push_back({time.value, time.value, time.value});
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
}

bool IsOfPlans(const ViewStudyRun& run) {
  return run.study.task == ViewTask::kGraspPlan || run.study.task == ViewTask::kGraspSuccess;
}

// How often each answer was given, all objects of a cell together: of rotations Figure 4.7.
BarFigure HistogramFigure(const ViewStudyRun& run) {
  BarFigure figure{.title = run.study.title, .y_label = "views", .groups = {}, .series = {}};
  // The names of all angles would lie over each other.
  const std::size_t named_bins = run.study.task == ViewTask::kObjectRotation ? 3 : 1;
  const std::vector<std::string>& bins = run.results.front().answers.columns;
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    figure.groups.push_back(bin % named_bins == 0 ? bins[bin] : "");
  }
  for (const ViewCellResult& result : run.results) {
    BarFigure::Series series{.name = result.id, .bars = {}};
    for (std::size_t column = 0; column < figure.groups.size(); ++column) {
      double sum = 0.0;
      for (const auto& row : result.answers.counts) sum += static_cast<double>(row[column]);
      series.bars.push_back({sum, sum, sum});
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
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
  table.head.emplace_back("right");
  for (std::size_t row = 0; row < answers.rows.size(); ++row) {
    std::vector<std::string> cells = {answers.rows[row]};
    for (const std::size_t count : answers.counts[row]) cells.push_back(NumberToText(count));
    cells.push_back(ShareText(result.groups[row].share));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string OutcomesSection(const ViewStudyRun& run) {
  if (!IsOfPlans(run)) return "";
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
  std::vector<NamedFigure> figures = {{"right_answers", SharesFigure(run)}};
  if (run.study.task == ViewTask::kObjectRotation) {
    figures.push_back({"rotation_histogram", HistogramFigure(run)});
  }
  if (IsOfPlans(run)) figures.push_back({"outcomes", HistogramFigure(run)});
  if (!run.study.claimed_ms.empty()) figures.push_back({"layer_times", TimesFigure(run)});
  for (NamedFigure& figure : ErrorFigures(run)) figures.push_back(std::move(figure));
  const ReportTable errors = ErrorsTable(run);
  FigureFiles files = WriteFigures(out / "figures", figures);
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
