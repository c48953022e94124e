// SPDX-FileCopyrightText: 2026 the Handcraft authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments/runner/results_csv.h"

#include <cmath>

#include "datasets/formats/csv_records.h"
#include "experiments/runner/result_columns.h"
#include "lib/core/check.h"
#include "lib/core/fields.h"

namespace handcraft::experiments {
namespace {

std::string NumberField(std::size_t number) { return NumberToText(number); }
std::string NumberField(double number) {
  return std::isnan(number) ? std::string() : NumberToText(number);
}

// Appends a column's name, or its number, to a line.
auto AppendName(std::string& line) {
  return [&line](const std::string& name, const auto&) { line += "," + name; };
}
auto AppendNumber(std::string& line) {
  return [&line](const std::string&, const auto& number) { line += "," + NumberField(number); };
}

std::string HeadOf(const Cell& cell) {
  std::string line = "cell,method";
  for (const Setting& factor : cell.factors) line += "," + factor.key;
  line += ",repetition,class,termination";
  const CellResult result;
  const GroupFigures group;
  VisitTrainingColumns(result, AppendName(line));
  VisitGroupColumns(group, AppendName(line));
  return line + "\n";
}

std::string RowOf(const Cell& cell, const CellResult& result, const GroupFigures& group) {
  std::string line = datasets::CsvField(cell.id) + "," + datasets::CsvField(cell.method);
  for (const Setting& factor : cell.factors) line += "," + datasets::CsvField(factor.value);
  line += "," + NumberToText(cell.repetition) + "," + datasets::CsvField(group.name) + "," +
          result.termination;
  VisitTrainingColumns(result, AppendNumber(line));
  VisitGroupColumns(group, AppendNumber(line));
  return line + "\n";
}

}  // namespace

std::string ResultsCsv(std::span<const Cell> cells, std::span<const CellResult> results) {
  HC_CHECK(!cells.empty() && cells.size() == results.size(), cells.size(), results.size());
  std::string text = HeadOf(cells.front());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const GroupFigures& group : results[i].groups) {
      text += RowOf(cells[i], results[i], group);
    }
  }
  return text;
}

std::string SearchSpaceCsv(std::span<const CellResult> results) {
  std::string text = "cell,num_images_without_region,stage";
  const SearchStageFigures empty;
  VisitStageColumns(empty, AppendName(text));
  text += "\n";
  for (const CellResult& result : results) {
    for (const SearchStageFigures& stage : result.search_space.stages) {
      std::string line = datasets::CsvField(result.id) + "," +
                         NumberToText(result.search_space.num_images_without_region) + "," +
                         stage.stage;
      VisitStageColumns(stage, AppendNumber(line));
      text += line + "\n";
    }
  }
  return text;
}

std::string TimesCsv(std::span<const CellResult> results) {
  std::string text = "cell";
  const CellResult empty;
  VisitTimeColumns(empty, AppendName(text));
  text += "\n";
  for (const CellResult& result : results) {
    std::string line = datasets::CsvField(result.id);
    VisitTimeColumns(result, AppendNumber(line));
    text += line + "\n";
  }
  return text;
}

}  // namespace handcraft::experiments
