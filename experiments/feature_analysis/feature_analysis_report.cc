// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_report.h"

#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/json_text.h"
#include "experiments/evaluation/report_table.h"
#include "experiments/feature_analysis/feature_analysis_plots.h"
#include "experiments/feature_analysis/feature_analysis_tables.h"
#include "lib/core/fields.h"

namespace handcraft::experiments {
namespace {

nlohmann::ordered_json ToJson(const FeatureAnalysis& analysis) {
  nlohmann::ordered_json json{{"features", features::ToString(analysis.options.spec)},
                              {"options", FieldsToText(analysis.options)},
                              {"data_fingerprint", analysis.data_fingerprint},
                              {"num_samples", analysis.num_samples},
                              {"num_fit_samples", analysis.num_fit_samples},
                              {"num_held_out_samples", analysis.num_held_out_samples},
                              {"num_fit_objects", analysis.num_fit_objects},
                              {"num_held_out_objects", analysis.num_held_out_objects}};
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    json["energy"][std::string(NameOf(spectrum.scaling))] = {
        {"num_components_90", spectrum.num_components[0]},
        {"num_components_95", spectrum.num_components[1]},
        {"num_components_99", spectrum.num_components[2]},
        {"filter_shares", spectrum.filter_shares},
        {"position_shares", spectrum.position_shares},
        {"ring_strengths", spectrum.ring_strengths}};
  }
  const BackwardElimination& elimination = analysis.elimination;
  json["elimination"] = {{"log_loss_all", elimination.all.log_loss},
                         {"auc_all", elimination.all.auc},
                         {"order", nlohmann::ordered_json::array()}};
  for (const std::size_t filter : elimination.order) {
    json["elimination"]["order"].push_back(NameOfFilter(analysis, filter));
  }
  json["hypotheses"] = nlohmann::ordered_json::array();
  for (const TestedHypothesis& tested : analysis.hypotheses) {
    nlohmann::ordered_json entry{{"name", tested.name},
                                 {"features", features::ToString(tested.spec)},
                                 {"num_features", tested.spec.NumFeatures()},
                                 {"log_loss", tested.log_loss},
                                 {"auc", tested.auc}};
    AddEstimate("log_loss_increase", tested.increase, entry);
    json["hypotheses"].push_back(std::move(entry));
  }
  return json;
}

std::string SetText(const FeatureAnalysis& analysis, const std::string& data_name) {
  const features::FeatureSpec& spec = analysis.options.spec;
  return fmt::format(
      "{} features ({} filters, {}×{} window, {} scales, energy {}) of {} pixels of {}; fits on {} "
      "pixels of {} objects, measured on {} pixels of {} other objects.",
      spec.NumFeatures(),
      spec.NumFilters(),
      spec.window,
      spec.window,
      spec.scales.size(),
      features::NameOf(spec.energy),
      analysis.num_samples,
      data_name,
      analysis.num_fit_samples,
      analysis.num_fit_objects,
      analysis.num_held_out_samples,
      analysis.num_held_out_objects);
}

constexpr std::string_view kEnergyNote =
    "A filter's share of the energy (variance) of the components that hold 99 % of it. It depends "
    "on the units in which a filter's response is written, which say nothing about grasping.";
constexpr std::string_view kUsefulnessNote =
    "Filters are taken away one by one, each time the one that the classifier misses least on "
    "objects it has not seen; the one that stays to the last is rank 1. The held-out pixels "
    "choose, so these figures are somewhat too good: measure what you choose on other pictures.";
constexpr std::string_view kSpectrumNote =
    "Eigenvalues over the largest, and how many components hold a share of their sum.";
constexpr std::string_view kWindowNote =
    "A pixel's share of the same energy, rank 1 the largest; and the height of the first "
    "eigenvector's peaks at the pixels of a ring around the middle, over the highest peak.";
constexpr std::string_view kHypothesisNote =
    "Log-loss in nats a pixel, below is better; the interval is a 95 % bootstrap over held-out "
    "objects.";

std::string MarkdownReport(const FeatureAnalysis& analysis, const std::string& data_name) {
  std::string text = "# Feature analysis\n\n" + SetText(analysis, data_name) + "\n\n";
  text += "## What may be dropped\n\n" + std::string(kHypothesisNote) + "\n\n" +
          MarkdownText(HypothesisTable(analysis, Reader::kPeople));
  text += "## Filters\n\n" + std::string(kEnergyNote) + " " + std::string(kUsefulnessNote) +
          "\n\n" + MarkdownText(FilterTable(analysis, Reader::kPeople));
  text += "## Components that hold 90, 95 and 99 % of the energy\n\n" +
          MarkdownText(ComponentTable(analysis));
  text += "## Window\n\n" + std::string(kWindowNote) + "\n\n" +
          MarkdownText(PositionTable(analysis, Reader::kPeople)) +
          MarkdownText(RingTable(analysis));
  text.pop_back();
  return text;
}

std::string Section(std::string_view title, std::string_view note, const std::string& content) {
  return fmt::format("<h2>{}</h2>\n<p class=\"note\">{}</p>\n{}", title, note, content);
}

std::string Figure(const SvgFigure& figure, std::string_view caption) {
  return fmt::format("<figure class=\"card wide\">\n{}<figcaption>{}</figcaption>\n</figure>\n",
                     figure.ToInlineText(),
                     caption);
}

// What was looked at, and how.
std::string FooterText(const FeatureAnalysis& analysis) {
  std::string text =
      fmt::format("<footer>Data <code>{}</code>. Features:", analysis.data_fingerprint);
  for (const features::Filter filter : analysis.options.spec.filters) {
    text += fmt::format(" {}", features::NameOf(filter));
  }
  text += ". Options:";
  for (const auto& [name, value] : FieldsToText(analysis.options)) {
    text += fmt::format(" {} = {};", EscapeHtml(name), EscapeHtml(value));
  }
  return text + "</footer>\n";
}

std::string HtmlReport(const FeatureAnalysis& analysis, const std::string& data_name) {
  std::string body = fmt::format(
      "<header>\n<p class=\"kicker\">Handcraft study</p>\n<h1>Feature analysis</h1>\n<p "
      "class=\"lead\">{}</p>\n</header>\n",
      EscapeHtml(SetText(analysis, data_name)));
  body += Section(
      "What may be dropped", kHypothesisNote, HtmlText(HypothesisTable(analysis, Reader::kPeople)));
  body += Section("Filters: energy and usefulness",
                  std::string(kEnergyNote) + " " + std::string(kUsefulnessNote),
                  Figure(PlotRankings(analysis),
                         "Green: edge masks; blue: Laws masks; brown: Sobel and Laplacian.") +
                      Figure(PlotElimination(analysis),
                             "Bars: 95 % interval of the increase above all filters (dashed).") +
                      HtmlText(FilterTable(analysis, Reader::kPeople)));
  body += Section("Spectrum",
                  kSpectrumNote,
                  Figure(PlotEigenvalues(analysis.spectra),
                         "Eigenvalues of the covariance, by units of the features.") +
                      HtmlText(ComponentTable(analysis)));
  std::string components;
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    components += Figure(PlotFirstComponent(spectrum, analysis.options.spec),
                         "First eigenvector, " + TitleOf(spectrum.scaling) + ".");
  }
  body += Section("First eigenvector",
                  "Its coefficients in the order of the features: a period for each window pixel.",
                  components);
  body +=
      Section("Window",
              kWindowNote,
              HtmlText(RingTable(analysis)) + HtmlText(PositionTable(analysis, Reader::kPeople)));
  return MakeHtmlPage("Feature analysis", body + FooterText(analysis));
}

}  // namespace

std::map<std::string, std::string> FeatureAnalysisFiles(const FeatureAnalysis& analysis,
                                                        const std::string& data_name) {
  std::map<std::string, std::string> files = {
      {"summary.md", MarkdownReport(analysis, data_name)},
      {"report.html", HtmlReport(analysis, data_name)},
      {"results.json", JsonText(ToJson(analysis))},
      {"filters.csv", CsvText(FilterTable(analysis, Reader::kMachines))},
      {"positions.csv", CsvText(PositionTable(analysis, Reader::kMachines))},
      {"eigenvalues.csv", CsvText(EigenvalueTable(analysis))},
      {"elimination.csv", CsvText(EliminationTable(analysis))},
      {"hypotheses.csv", CsvText(HypothesisTable(analysis, Reader::kMachines))},
      {"eigenvalues.svg", PlotEigenvalues(analysis.spectra).ToFileText()},
      {"rankings.svg", PlotRankings(analysis).ToFileText()},
      {"elimination.svg", PlotElimination(analysis).ToFileText()}};
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    files[fmt::format("first_eigenvector_{}.svg", NameOf(spectrum.scaling))] =
        PlotFirstComponent(spectrum, analysis.options.spec).ToFileText();
  }
  return files;
}

}  // namespace handcraft::experiments
