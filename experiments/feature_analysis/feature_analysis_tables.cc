// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/feature_analysis/feature_analysis_tables.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "experiments/evaluation/html_text.h"
#include "experiments/evaluation/json_text.h"
#include "experiments/feature_analysis/feature_analysis_plots.h"
#include "lib/core/fields.h"

namespace handcraft::experiments {
namespace {

std::string NumberOrEmpty(double value) { return std::isnan(value) ? "" : NumberToText(value); }

std::string IncreaseText(const Estimate& increase) {
  if (std::isnan(increase.low)) return fmt::format("{:+.4f}", increase.value);
  return fmt::format("{:+.4f} [{:+.4f}, {:+.4f}]", increase.value, increase.low, increase.high);
}

// The step at which a filter goes; the last one never does.
const EliminationStep* StepOf(const FeatureAnalysis& analysis, std::size_t filter) {
  for (const EliminationStep& step : analysis.elimination.steps) {
    if (step.removed == filter) return &step;
  }
  return nullptr;
}

std::string Share(double share, Reader reader) {
  return reader == Reader::kPeople ? fmt::format("{:.2f} %", 100.0 * share) : NumberToText(share);
}

// Two columns for each spectrum: the share of the energy and the rank by it. Returns the ranks.
std::vector<std::vector<std::size_t>> AddShareColumns(const FeatureAnalysis& analysis,
                                                      std::vector<double> EnergySpectrum::*shares,
                                                      Reader reader,
                                                      ReportTable& table) {
  std::vector<std::vector<std::size_t>> ranks;
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    const bool people = reader == Reader::kPeople;
    const std::string name =
        people ? TitleOf(spectrum.scaling) : std::string(NameOf(spectrum.scaling));
    table.head.push_back(people ? "energy, " + name : "energy_share_" + name);
    table.head.push_back(people ? "rank" : "energy_rank_" + name);
    ranks.push_back(RanksOf(spectrum.*shares));
  }
  return ranks;
}

ReportTable HypothesisTableForPeople(const FeatureAnalysis& analysis) {
  ReportTable table{.head = {"hypothesis",
                             "filters kept",
                             "window",
                             "features",
                             "held-out log-loss",
                             "AUC",
                             "log-loss above all features"},
                    .rows = {}};
  for (const TestedHypothesis& tested : analysis.hypotheses) {
    table.rows.push_back({tested.name,
                          KeptFiltersText(tested.spec, analysis.options.spec),
                          fmt::format("{}×{}", tested.spec.window, tested.spec.window),
                          std::to_string(tested.spec.NumFeatures()),
                          DecimalText(tested.log_loss, 4),
                          DecimalText(tested.auc, 3),
                          IncreaseText(tested.increase)});
  }
  return table;
}

}  // namespace

std::string NameOfFilter(const FeatureAnalysis& analysis, std::size_t filter) {
  return std::string(features::NameOf(analysis.options.spec.filters[filter]));
}

ReportTable FilterTable(const FeatureAnalysis& analysis, Reader reader) {
  ReportTable table{.head = {"filter"}, .rows = {}};
  const auto ranks = AddShareColumns(analysis, &EnergySpectrum::filter_shares, reader, table);
  table.head.emplace_back(reader == Reader::kPeople ? "rank by usefulness" : "usefulness_rank");
  table.head.emplace_back(reader == Reader::kPeople ? "log-loss once it is gone"
                                                    : "log_loss_without");
  const std::vector<std::size_t> usefulness = UsefulnessRanks(analysis.elimination);
  for (std::size_t f = 0; f < analysis.options.spec.filters.size(); ++f) {
    std::vector<std::string> row = {NameOfFilter(analysis, f)};
    for (std::size_t s = 0; s < analysis.spectra.size(); ++s) {
      row.push_back(Share(analysis.spectra[s].filter_shares[f], reader));
      row.push_back(std::to_string(ranks[s][f]));
    }
    row.push_back(std::to_string(usefulness[f]));
    const EliminationStep* step = StepOf(analysis, f);
    if (step == nullptr) {
      row.emplace_back(reader == Reader::kPeople ? "–" : "");
    } else {
      row.push_back(reader == Reader::kPeople ? DecimalText(step->log_loss, 4)
                                              : NumberToText(step->log_loss));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable PositionTable(const FeatureAnalysis& analysis, Reader reader) {
  ReportTable table{.head = {"position"}, .rows = {}};
  const auto ranks = AddShareColumns(analysis, &EnergySpectrum::position_shares, reader, table);
  const std::vector<std::string> names = PositionNames(analysis.options.spec);
  for (std::size_t p = 0; p < names.size(); ++p) {
    std::vector<std::string> row = {names[p]};
    for (std::size_t s = 0; s < analysis.spectra.size(); ++s) {
      row.push_back(Share(analysis.spectra[s].position_shares[p], reader));
      row.push_back(std::to_string(ranks[s][p]));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable EigenvalueTable(const FeatureAnalysis& analysis) {
  ReportTable table{.head = {"component"}, .rows = {}};
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    table.head.emplace_back(NameOf(spectrum.scaling));
  }
  for (std::size_t k = 0; k < analysis.pca.num_features; ++k) {
    table.rows.push_back({std::to_string(k + 1)});
    for (const EnergySpectrum& spectrum : analysis.spectra) {
      table.rows.back().push_back(NumberToText(spectrum.eigenvalues[k]));
    }
  }
  return table;
}

ReportTable ComponentTable(const FeatureAnalysis& analysis) {
  ReportTable table{.head = {"features in units", "90 %", "95 %", "99 %"}, .rows = {}};
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    table.rows.push_back({TitleOf(spectrum.scaling)});
    for (const std::size_t count : spectrum.num_components) {
      table.rows.back().push_back(std::to_string(count));
    }
  }
  return table;
}

ReportTable RingTable(const FeatureAnalysis& analysis) {
  ReportTable table{.head = {"features in units"}, .rows = {}};
  for (std::size_t ring = 0; ring < analysis.spectra.front().ring_strengths.size(); ++ring) {
    table.head.push_back(ring == 0 ? "middle pixel" : fmt::format("ring {}", ring));
  }
  for (const EnergySpectrum& spectrum : analysis.spectra) {
    table.rows.push_back({TitleOf(spectrum.scaling)});
    for (const double strength : spectrum.ring_strengths) {
      table.rows.back().push_back(fmt::format("{:.1f} %", 100.0 * strength));
    }
  }
  return table;
}

ReportTable EliminationTable(const FeatureAnalysis& analysis) {
  ReportTable table{.head = {"filters_left",
                             "removed",
                             "num_features",
                             "log_loss",
                             "auc",
                             "increase",
                             "increase_low",
                             "increase_high"},
                    .rows = {}};
  std::size_t left = analysis.elimination.order.size();
  for (const EliminationStep& step : analysis.elimination.steps) {
    table.rows.push_back({std::to_string(--left),
                          NameOfFilter(analysis, step.removed),
                          std::to_string(step.num_columns),
                          NumberToText(step.log_loss),
                          NumberOrEmpty(step.auc),
                          NumberToText(step.increase.value),
                          NumberOrEmpty(step.increase.low),
                          NumberOrEmpty(step.increase.high)});
  }
  return table;
}

ReportTable HypothesisTable(const FeatureAnalysis& analysis, Reader reader) {
  if (reader == Reader::kPeople) return HypothesisTableForPeople(analysis);
  ReportTable table{.head = {"hypothesis",
                             "features",
                             "num_features",
                             "log_loss",
                             "auc",
                             "increase",
                             "increase_low",
                             "increase_high"},
                    .rows = {}};
  for (const TestedHypothesis& tested : analysis.hypotheses) {
    table.rows.push_back({tested.name,
                          features::ToString(tested.spec),
                          std::to_string(tested.spec.NumFeatures()),
                          NumberToText(tested.log_loss),
                          NumberOrEmpty(tested.auc),
                          NumberToText(tested.increase.value),
                          NumberOrEmpty(tested.increase.low),
                          NumberOrEmpty(tested.increase.high)});
  }
  return table;
}

std::string KeptFiltersText(const features::FeatureSpec& part, const features::FeatureSpec& whole) {
  std::vector<std::string_view> kept;
  std::vector<std::string_view> dropped;
  for (const features::Filter filter : whole.filters) {
    const bool stays =
        std::find(part.filters.begin(), part.filters.end(), filter) != part.filters.end();
    (stays ? kept : dropped).push_back(features::NameOf(filter));
  }
  if (dropped.empty()) return fmt::format("all {}", kept.size());
  if (dropped.size() < kept.size()) return fmt::format("all but {}", fmt::join(dropped, ", "));
  return fmt::format("{}", fmt::join(kept, ", "));
}

std::vector<std::string> PositionNames(const features::FeatureSpec& spec) {
  std::vector<std::string> names;
  for (int j = 0; j < spec.NumFeatures(); j += spec.NumFilters()) {
    const std::string name = features::FeatureName(spec, j);
    names.push_back(name.substr(name.find('@') + 1));
  }
  return names;
}

}  // namespace handcraft::experiments
